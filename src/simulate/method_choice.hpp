// The method of a run: which one, and by which steps.
#pragma once

#include "elgen/simulate.hpp"
#include "simulate/steps/methods.hpp"

namespace elgen {

/// The row of the method that is asked for. E620 with a suggestion.
[[nodiscard]] Result<MethodRow> find_method(const SimulationOptions& options);

/// The rule of its steps. E621: impossible numbers, a step and a tolerance, or neither where the
/// method needs one.
[[nodiscard]] Result<StepRule> step_rule(const MethodRow& method, const SimulationOptions& options);

}  // namespace elgen
