// ImportedModel: a robot description (URDF) as the text of a model file.
//
// Every link that moves is a frame and a body, every joint that moves a coordinate and an input;
// numbers are the digits of the URDF. Shapes, colours and transmissions are not mechanics and are
// left out silently; whatever else is left out is a note (E815), or a warning if it is mechanics
// (E822).
#pragma once

#include <string>
#include <vector>

#include "elgen/diagnostic.hpp"
#include "elgen/limits.hpp"
#include "elgen/source_text.hpp"

namespace elgen {

struct ImportedModel {
  std::string text;  ///< TOML, as parse_model() reads it
  std::string name;  ///< of the model
};

/// The requests to the model beyond what the file says.
struct ImportOptions {
  std::string name = {};                   ///< of the model; empty: the robot's
  std::vector<SourcePointer> joints = {};  ///< "a,b": these move, in this order, and no others
  std::vector<SourcePointer> welds = {};   ///< "JOINT", "JOINT=0.5" or "massless"
  bool floating_base = false;              ///< the root link moves freely
  bool exact_angles = false;               ///< no angle is taken for a right one
  std::string file = {};                   ///< that the text names; empty: that of the source
};

/// Errors: E8xx, all of the file in one run where it is XML; warnings: E508, E814, E817, E822;
/// notes: E815, E816, E818 to E820.
[[nodiscard]] Result<ImportedModel> import_urdf(const SourcePointer& source, const Limits& limits,
                                                const ImportOptions& options = {});

}  // namespace elgen
