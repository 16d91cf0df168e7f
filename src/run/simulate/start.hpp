// The start of a run, and what forbids it.
#pragma once

#include <algorithm>
#include <cmath>

#include "run/steps/system.hpp"

namespace elgen {

/// A smaller move of the start is not told, since it would not be seen in what is printed.
[[nodiscard]] inline bool is_visible_move(double from, double to) {
  return std::abs(to - from) > 1e-9 * std::max(1.0, std::abs(from));
}

/// Whether the acceleration is determined where a run starts: charts by the factors that the model
/// states, M and A M^-1 A^T by their relative pivots. E623.
[[nodiscard]] Diagnostics refuse_start(System& system, const Numbers& state, double t);

}  // namespace elgen
