// The method of a run: which one, by which steps, and whether it is for the system.
#pragma once

#include "elgen/simulate.hpp"
#include "simulate/steps/methods.hpp"

namespace elgen {

/// The row of the method. E620 with a suggestion.
[[nodiscard]] Result<MethodRow> find_method(const std::string& name);

/// The rule of its steps. E621: impossible numbers, a step and a tolerance, or neither where the
/// method needs one.
[[nodiscard]] Result<StepRule> step_rule(const MethodRow& method, const SimulationOptions& options);

/// E622 where the method is not for the system, with what is in its way and another method.
[[nodiscard]] Diagnostics refuse_method(const MethodRow& method, const CheckedModel& checked,
                                        const Program& program, const SimulationOptions& options);

}  // namespace elgen
