// Diagnostics as text to compare: "E501: message", one line each.
#pragma once

#include <string>

#include "elgen/diagnostic.hpp"

namespace elgen::test {

inline std::string text_of(const Diagnostics& diagnostics) {
  std::string lines;
  for (const Diagnostic& d : diagnostics) {
    lines += (lines.empty() ? "" : "\n") + std::string(code_row(d.code).name) + ": " + d.message;
  }
  return lines;
}

}  // namespace elgen::test
