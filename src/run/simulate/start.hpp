// The start of a run, and the errors that prevent a run.
#pragma once

#include <algorithm>
#include <cmath>

#include "run/steps/system.hpp"

namespace elgen {

/// A smaller move of the start is not reported, because printed numbers do not show it.
[[nodiscard]] inline bool is_visible_move(double from, double to) {
  return std::abs(to - from) > 1e-9 * std::max(1.0, std::abs(from));
}

/// E623 if the start does not determine the acceleration: a factor that the model declares singular
/// is 0, or a relative pivot of M or of A M^-1 A^T is.
[[nodiscard]] Diagnostics refuse_start(System& system, const Numbers& state, double t);

}  // namespace elgen
