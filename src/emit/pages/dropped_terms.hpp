// dropped_terms: what `drop_below` left out, in a line of prose.
#pragma once

#include <string>

#include "elgen/program.hpp"

namespace elgen {

/// "3 terms below 0.001 of …"; empty where the program is that of the exact model.
[[nodiscard]] std::string dropped_summary(const Program& program);

}  // namespace elgen
