// SPDX-License-Identifier: GPL-3.0-or-later
// The start of a run, and what forbids it.
#pragma once

#include "simulate/steps/system.hpp"

namespace elgen {

/// Whether the acceleration is determined where a run starts: charts by the factors that the model
/// states, M and A M^-1 A^T by their relative pivots. E623.
[[nodiscard]] Diagnostics refuse_start(System& system, const Numbers& state, double t);

}  // namespace elgen
