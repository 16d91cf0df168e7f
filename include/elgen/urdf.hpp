// ImportedModel: a robot description (URDF) as the text of a model file.
//
// Every link that moves is a frame and a body, every joint that moves a coordinate and an input;
// numbers are the digits of the URDF. Shapes, colours and transmissions are not mechanics and are
// left out silently; whatever else is left out is a note (E815).
#pragma once

#include <string>

#include "elgen/diagnostic.hpp"
#include "elgen/limits.hpp"
#include "elgen/source_text.hpp"

namespace elgen {

struct ImportedModel {
  std::string text;  ///< TOML, as parse_model() reads it
};

/// Errors: E8xx, all of the file in one run where it is XML; warnings: E508; notes: E815 to E817.
[[nodiscard]] Result<ImportedModel> import_urdf(const SourcePointer& source, const Limits& limits);

}  // namespace elgen
