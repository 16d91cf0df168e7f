// The start of a run, and the errors that refuse a start.
#pragma once

#include <algorithm>
#include <cmath>

#include "run/steps/system.hpp"

namespace elgen {

/// True if a printed number would show the change. Smaller corrections of the start are not
/// reported.
[[nodiscard]] inline bool is_visible_change(double from, double to) {
  return std::abs(to - from) > 1e-9 * std::max(1.0, std::abs(from));
}

/// E623 if the accelerations at the start are not determined: a factor that the model declares
/// singular is 0, or a relative pivot of M or of A M^-1 A^T is 0 up to rounding.
[[nodiscard]] Diagnostics check_singular_start(SimulatedSystem& system, const Numbers& state,
                                               double t);

}  // namespace elgen
