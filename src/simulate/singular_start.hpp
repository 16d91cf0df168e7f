// Whether the acceleration is determined where a run starts.
#pragma once

#include "elgen/diagnostic.hpp"
#include "simulate/steps/system.hpp"

namespace elgen {

/// E623 where a factor that the model states as `singular` is zero at q, or M is singular.
[[nodiscard]] Diagnostics refuse_start(System& system, const Numbers& state, double t);

}  // namespace elgen
