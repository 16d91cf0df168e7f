// What the printer and the reader of the text form of a Program share: the words.
#pragma once

#include <string_view>

#include "elgen/program.hpp"

namespace elgen {

/// How a function's heading names its output: as the table of outputs does, users' ones by their
/// kind.
[[nodiscard]] inline std::string_view kind_name(OutputKind kind) {
  switch (kind) {
    case OutputKind::user_value:
      return "user_value";
    case OutputKind::user_jacobian:
      return "user_jacobian";
    case OutputKind::user_bias:
      return "user_bias";
    default:
      return output_row(kind).name;
  }
}

}  // namespace elgen
