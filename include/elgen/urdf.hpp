// ImportedModel: a robot description (URDF), translated into a model file.
//
// Every moving link becomes a frame and a body, every moving joint a coordinate and an input.
// Numbers keep the digits of the URDF. Shapes, colours and transmissions are omitted without a
// message. For all other elements, warning E822 reports an omission that changes the mechanics,
// note E815 any other omission.
#pragma once

#include <string>
#include <vector>

#include "elgen/diagnostic.hpp"
#include "elgen/limits.hpp"
#include "elgen/source_text.hpp"

namespace elgen {

struct ImportedModel {
  std::string text;  ///< TOML, as parse_model() reads it
  std::string name;  ///< name of the model
};

/// Options of an import.
struct ImportOptions {
  std::string name = {};                   ///< name of the model; empty: the name of the robot
  std::vector<SourcePointer> joints = {};  ///< "a,b": joints that move, in this order; {}: all
  std::vector<SourcePointer> welds = {};   ///< held joints: "JOINT", "JOINT=0.5" or "massless"
  bool floating_base = false;              ///< true: the root link moves freely
  bool exact_angles = false;  ///< true: angles close to a right angle are not rounded to it
  std::string file = {};      ///< URDF file named in the text; empty: file name of the source
};

/// Translates a URDF file. Errors: E8xx; if the file is valid XML, all errors are reported at once.
/// Warnings: E508, E814, E817, E822. Notes: E815, E816, E818 to E820.
[[nodiscard]] Result<ImportedModel> import_urdf(const SourcePointer& source, const Limits& limits,
                                                const ImportOptions& options = {});

}  // namespace elgen
