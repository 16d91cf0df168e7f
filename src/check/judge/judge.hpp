// Judge: whether resolved entries have equations of motion. Reads their closed forms: [[expect]] ->
// Model::expectations.
#pragma once

#include <optional>
#include <vector>

#include "check/expressions/traits.hpp"
#include "check/names/context.hpp"
#include "elgen/syntax.hpp"

namespace elgen {

/// E112, E503, E504, E509, E513, E514, E515; sets Model::quadratic, uses_time and may_drift.
void check_mechanics(Context& context, const std::vector<Traits>& traits);

/// Which velocities are in some energy: T, L, or the motion of a point or body with mass.
[[nodiscard]] std::vector<bool> moving_velocities(const Model& model);

/// Writes sin(a)/a, (1 - cos(a))/a and (1 - cos(a))/a^2 by Stumpff's functions if a is a multiple
/// of a coordinate, in equations and outputs. Fills Model::typed.
void write_quotients(Context& context);

/// E535, E536, E539 of the constraints of a model that is reduced.
void check_constraints(Context& context);

/// The state of an [[expect]] that has one. E112, E201, E319.
[[nodiscard]] std::optional<StatedState> read_stated_state(Context& context,
                                                           const EntrySyntax& entry);

/// E540: an equation of [[expect]] that holds no acceleration, or too few of them.
void check_equations(Context& context, const std::vector<Traits>& traits);

/// Resolves every closed form and compares its shape with that of the output. Closed forms of sized
/// models grow faster than the model, so that those of more than 4096 nodes are kept only where
/// `large`. E517, E601, E603, E505, and those of states.
void read_expectations(Context& context, const FileSyntax& syntax, bool large);

}  // namespace elgen
