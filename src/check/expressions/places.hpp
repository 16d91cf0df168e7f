// Places: the ingredients (leaves and functions) that each kind of expression may contain. For
// example, a position may contain coordinates but no rate, and an energy may contain no input. No
// name may occur in its own definition.
#pragma once

#include <vector>

#include "check/expressions/traits.hpp"
#include "check/names/context.hpp"

namespace elgen {

namespace place {

inline constexpr Ingredients constants_only = 0;
inline constexpr Ingredients parameters_only = uses_parameter;
inline constexpr Ingredients time_terms = uses_parameter | uses_time;
inline constexpr Ingredients configuration_terms = time_terms | uses_coordinate;
inline constexpr Ingredients state_terms = configuration_terms | uses_rate;
inline constexpr Ingredients energy_terms = state_terms | uses_open_function;
inline constexpr Ingredients dissipation_terms = energy_terms | uses_open_rate;
inline constexpr Ingredients force_terms = dissipation_terms | uses_input | uses_kink;
inline constexpr Ingredients all_terms = force_terms | uses_acceleration | uses_open_derivative;

inline constexpr std::string_view position = "a position";
inline constexpr std::string_view position_equation = "a constraint on positions";
inline constexpr std::string_view velocity_equation = "a constraint on velocities";

}  // namespace place

/// False after E206, which prints a cycle of definitions, prescribed functions, points, bodies and
/// frames: `a -> b -> a`.
[[nodiscard]] bool check_cycles(Context& context);

/// Reports each forbidden ingredient at the node that introduces it: E315, E319, E502, E506.
void check_ingredients(Context& context, const std::vector<ExpressionTraits>& traits);

}  // namespace elgen
