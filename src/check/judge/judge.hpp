// Checks whether the resolved entries define equations of motion. Reads closed forms: [[expect]] ->
// Model::expectations.
#pragma once

#include <optional>
#include <vector>

#include "check/expressions/traits.hpp"
#include "check/names/context.hpp"
#include "elgen/syntax.hpp"

namespace elgen {

/// Checks energies, inputs, forces and moving masses: E112, E503, E504, E509, E513, E514, E515.
/// Sets Model::is_quadratic, uses_time and may_drift.
void check_mechanics(Context& context, const std::vector<ExpressionTraits>& traits);

/// One flag per velocity: true if T, L, a spin, or the motion of a point or body with mass contains
/// the velocity, or if the coordinate of the velocity has an armature.
[[nodiscard]] std::vector<bool> velocities_with_energy(const Model& model);

/// Rewrites sin(a)/a, (1 - cos(a))/a and (1 - cos(a))/a^2 as Stumpff functions in equations and
/// outputs, if a is a multiple of a coordinate. Fills Model::original_expressions.
void rewrite_quotients(Context& context);

/// Checks the constraints of a reduced model: E535, E536, E539.
void check_constraints(Context& context);

/// The state of an [[expect]], with leaves of `described`; none if it has no `at`. E112, E201,
/// E319.
[[nodiscard]] std::optional<ExpectationState> read_expected_state(Context& context,
                                                                  const Model& described,
                                                                  const EntrySyntax& entry);

/// Reports E540 if an equation of [[expect]] contains neither accelerations nor multipliers.
void check_expected_equations(Context& context, const std::vector<ExpressionTraits>& traits);

struct ExpectationOptions {
  /// True: closed forms with more than 4096 nodes are kept, although the forms of sized models grow
  /// faster than the model.
  bool keeps_large_forms = false;
  bool only_conserved = false;  ///< true: only the keys `conserved` are read
  /// The model with the shapes and leaves of the claims: Context::model, or this model without the
  /// variables that the scene holds.
  const Model& described;
};

/// Resolves every closed form and compares its shape with the output's. E517, E601, and the errors
/// of require_request() and read_expected_state(). E319: a momentum of a coordinate that the
/// scene removes, in its own [[expect]].
void read_expectations(Context& context, const FileSyntax& syntax,
                       const ExpectationOptions& options);

}  // namespace elgen
