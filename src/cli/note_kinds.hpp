// Notes of one kind as one line, where people read them.
#pragma once

#include "elgen/diagnostic.hpp"

namespace elgen::cli {

/// Notes that say the same of many places become one without a place; errors, warnings and notes of
/// their own stay.
[[nodiscard]] Diagnostics one_per_kind(const Diagnostics& diagnostics);

}  // namespace elgen::cli
