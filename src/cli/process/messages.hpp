// Messages: texts and diagnostics on stderr.
#pragma once

#include <string>

#include "elgen/diagnostic.hpp"

namespace elgen::cli {

/// Where stderr cannot be written, nobody can be told.
void say(const std::string& text);

/// Whole, whatever limit is met meanwhile.
void say(const Diagnostics& diagnostics, const DiagnosticStyle& style);

}  // namespace elgen::cli
