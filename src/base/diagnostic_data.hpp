// diagnostic_data: a diagnostic for programs.
#pragma once

#include <string>

#include "elgen/diagnostic.hpp"

namespace elgen {

/// An object on a line of its own.
[[nodiscard]] std::string json_line(const Diagnostic& diagnostic);

}  // namespace elgen
