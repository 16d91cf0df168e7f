// ImportedModel: a robot description (URDF), translated into a model file.
//
// Every moving link becomes a frame and a body, every moving joint a coordinate and an input.
// Numbers keep the digits of the URDF. Shapes, colours and transmissions are omitted silently.
// Other omissions are noted (E815), or warned of if they are mechanics (E822).
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

/// Options of an import.
struct ImportOptions {
  std::string name = {};                   ///< of the model; empty: the name of the robot
  std::vector<SourcePointer> joints = {};  ///< "a,b": only these joints move, in this order
  std::vector<SourcePointer> welds = {};   ///< "JOINT", "JOINT=0.5" or "massless"
  bool floating_base = false;              ///< the root link moves freely
  bool exact_angles = false;               ///< angles near a right angle are not rounded to it
  std::string file = {};                   ///< file name in the text; empty: the name of the source
};

/// Errors: E8xx, all in one run if the file is XML. Warnings: E508, E814, E817, E822. Notes: E815,
/// E816, E818 to E820.
[[nodiscard]] Result<ImportedModel> import_urdf(const SourcePointer& source, const Limits& limits,
                                                const ImportOptions& options = {});

}  // namespace elgen
