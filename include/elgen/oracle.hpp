// Oracle: every output to 60 digits, computed from the energies of the Model. The oracle works with
// more digits (oracle/real_functions.hpp); Real has 64.
//
// THIS CODE IS SLOW ON PURPOSE: it evaluates the expressions of the Model with nested dual numbers.
// It shares no code with the derivation, so that each checks the other. It uses the defining
// equations (here for v = dq/dt):
//
//     tau   = d/dt dL/dv - dL/dq + dD/dv - Q
//     M     = d2L/dv2
//     C_ij  = 1/2 dh_i/dv_j = 1/2 (h(v + e_j) - h(v) - h(e_j))_i
//             h = C v, quadratic in v, from the Christoffel symbols of M
//     drift = bias - C v - g - dD/dv + Q
//     E     = sum v dL/dv - L
//
// With rotations dq/dt = N(q) v: d/dq becomes the derivative along the columns of N, and d/dt dL/dv
// and C have the additional terms of mechanics.hpp.
#pragma once

#include <cln/float.h>
#include <cln/real.h>

#include <optional>
#include <vector>

#include "elgen/leaves.hpp"
#include "elgen/model.hpp"
#include "elgen/scene.hpp"

namespace elgen {

/// The values of all leaves, in SI units. Numbers that come from doubles or decimal text are exact
/// rationals.
using State = LeafValues<cln::cl_R>;

/// The state with the parameter values of the model (or the scene, if it fixes them), quaternions
/// (1, 0, 0, 0), and 0 for all other leaves.
[[nodiscard]] State nominal_state(const Model& model, const Scene& scene);

/// nominal_state(), but coordinates and rates have their declared start values.
[[nodiscard]] State start_state(const Model& model, const Scene& scene);

/// Replaces every quaternion by a rational quaternion of length 1, computed from the last three
/// components.
void set_rational_quaternions(const Model& model, State& state);

/// The entries of an output, field after field, row-major, with the shapes and units of the output
/// table. None if an intermediate value is undefined (sqrt(-1), 1/0).
using OracleValues = std::optional<std::vector<cln::cl_R>>;

[[nodiscard]] OracleValues oracle_values(const Model& model, const OutputRequest& output,
                                         const State& state);

/// Values whose first 60 digits are the same after a computation with more digits. A value that is
/// pure rounding error at the highest precision is set to 0.
struct StableValues {
  OracleValues values = {};
  /// False: at the highest precision a value cannot be distinguished from 0, or a number is too
  /// large.
  bool is_decided = true;
};
inline constexpr unsigned max_stable_digits = 2000;

/// The entries of an output. Cost: at least two evaluations.
[[nodiscard]] StableValues stable_values(const Model& model, const OutputRequest& output,
                                         const State& state);

/// The value of one expression, as a single entry. Cost: at least two evaluations.
[[nodiscard]] StableValues stable_expression_value(const Model& model, ExpressionId expression,
                                                   const State& state);

/// d/ds of w.(M a + bias - B u) for the variations dq/ds = N x and dv/ds = y; a and u of the state
/// are constant. w, x and y have one entry per velocity; for a rotation, x is an infinitesimal
/// rotation vector in body axes.
[[nodiscard]] std::optional<cln::cl_R> oracle_residual_slope(const Model& model, const State& state,
                                                             const std::vector<cln::cl_R>& w,
                                                             const std::vector<cln::cl_R>& x,
                                                             const std::vector<cln::cl_R>& y);

/// Vectors that contract a field X of an output to a number: w.X if X is a column, w.(X y) if X is
/// a matrix. w has one entry per row of X, y one per column; y is empty if X is a column.
struct Contraction {
  std::vector<cln::cl_R> w = {};
  std::vector<cln::cl_R> y = {};
  std::size_t field = 0;  ///< index of the field, in the order of the output table
};

/// The contraction of one field of an output, for self-checks of large models. Cost: a few
/// directional derivatives, or all entries of the output if oracle_needs_entries().
[[nodiscard]] std::optional<cln::cl_R> oracle_contraction(const Model& model,
                                                          const OutputRequest& output,
                                                          const State& state,
                                                          const Contraction& by);

/// True if contractions need all entries of the output, because no directional derivatives give
/// them. Examples: energies, forward_dynamics, step.
[[nodiscard]] bool oracle_needs_entries(const OutputRequest& output);

/// The contraction of one field, from the oracle_values() of the output.
[[nodiscard]] cln::cl_R contract_entries(const Model& model, const OutputRequest& output,
                                         const std::vector<cln::cl_R>& values,
                                         const Contraction& by);

/// The sum of |E| and the magnitudes of the terms of V, in J: the scale of rounding errors in L.
[[nodiscard]] std::optional<cln::cl_R> oracle_energy_magnitude(const Model& model,
                                                               const State& state);

/// The result of Newton's method on the constraints.
struct Assembly {
  State state = {};
  bool has_pose = false;   ///< true: the pose satisfies f = 0, to 60 digits of the coordinates
  bool has_rates = false;  ///< true: the rates satisfy r = 0 at this pose (see Constraint)
};

/// For each velocity: true if an assembly must not change the coordinate (in `positions`) or the
/// rate (in `rates`). Empty: an assembly may change all coordinates or rates.
struct FixedVariables {
  std::vector<bool> positions = {};
  std::vector<bool> rates = {};
};

/// `state`, moved onto the constraints by Newton steps (see the output `projected`), then with
/// corrected rates. A step is halved until the residuals decrease. The variables in `kept` do not
/// change. None if an equation has no value at the state.
[[nodiscard]] std::optional<Assembly> oracle_assembly(const Model& model, const State& state,
                                                      const FixedVariables& kept = {});

/// The state that oracle_assembly() finds from `state`; none if it violates the constraints.
[[nodiscard]] std::optional<State> oracle_assembled_state(const Model& model, State state);

/// The relative pivots D_i / M_ii of a symmetric n x n matrix M = L D L^T, eliminated from the
/// first row to the last. None if a pivot is 0.
[[nodiscard]] OracleValues oracle_relative_pivots(std::vector<cln::cl_R> matrix, std::size_t n);

/// The value of one expression of the model (for [[expect]]), with all leaves from the state.
[[nodiscard]] std::optional<cln::cl_R> oracle_expression_value(const Model& model,
                                                               ExpressionId expression,
                                                               const State& state);

/// sum d(expression)/dx dx over all leaves x, with dx from `direction`, at `state`. The expression
/// must not contain open functions.
[[nodiscard]] std::optional<cln::cl_R> oracle_directional_derivative(const Model& model,
                                                                     ExpressionId expression,
                                                                     const State& state,
                                                                     const State& direction);

/// d/dt of an expression along the motion with acceleration state.a (for `conserved`). The leaves p
/// and E in the expression are computed from q, v and t, not taken from the state.
[[nodiscard]] std::optional<cln::cl_R> oracle_expression_rate(const Model& model,
                                                              ExpressionId expression,
                                                              const State& state);

/// True if the parameters of a state meet a condition.
[[nodiscard]] bool oracle_satisfies(const Model& model, const Condition& condition,
                                    const State& state);

/// The state of rest at a stated point. `state` provides the parameters, and the coordinates that
/// the point does not determine; inputs without a stated value are 0. None if a value is undefined.
[[nodiscard]] std::optional<State> oracle_rest_state(const Model& model,
                                                     const OperatingPoint& point, State state);

}  // namespace elgen
