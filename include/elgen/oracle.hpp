// Oracle: every output to 60 digits, computed from the energies of the Model. All texts state 60
// digits; the oracle works with more (oracle/real_functions.hpp), and Real has 64.
//
// THIS CODE IS SLOW ON PURPOSE: nested dual numbers on the expressions of the Model. It shares no
// code with the derivation, so that each checks the other. Equations as defined (v = dq/dt):
//
//     tau = d/dt dL/dv - dL/dq + dD/dv - Q,   M = d2L/dv2,   h = C v from the Christoffel symbols
//     of M, C e_j = 1/2 (h(v + e_j) - h(v) - h(e_j)),  C_ij = 1/2 dh_i/dv_j, drift = bias - C v - g
//     - dD/dv + Q,   E = sum v dL/dv - L.
//
// With angular velocities dq/dt = N(q) v. Derivatives by q are then along N, and d/dt dL/dv and C
// have the additional terms of mechanics.hpp.
#pragma once

#include <cln/float.h>
#include <cln/real.h>

#include <optional>
#include <vector>

#include "elgen/leaves.hpp"
#include "elgen/model.hpp"
#include "elgen/scene.hpp"

namespace elgen {

/// A point of evaluation, in the declared units of the model. Values from binary or decimal inputs
/// are exact rationals.
using State = LeafValues<cln::cl_R>;

/// Parameters at their values (or as the scene fixes them), quaternions at (1, 0, 0, 0), all other
/// leaves 0. The lists have the sizes of the model.
[[nodiscard]] State nominal_state(const Model& model, const Scene& scene);

/// nominal_state() with the declared start of coordinates and rates.
[[nodiscard]] State start_state(const Model& model, const Scene& scene);

/// Replaces every quaternion by a rational one of length 1, computed from its last three
/// components.
void make_unit_quaternions(const Model& model, State& state);

/// The fields of an output one after another, row-major, with the shapes and units of the output
/// table. Empty if an intermediate value is undefined (sqrt(-1), 1/0).
using OracleValues = std::optional<std::vector<cln::cl_R>>;

[[nodiscard]] OracleValues oracle_values(const Model& model, const OutputRequest& output,
                                         const State& state);

/// Values whose first 60 digits stay when recomputed with more digits. A value is set to 0 if it is
/// exactly 0. It is also set to 0 if it is pure rounding although the precision would reveal any
/// non-zero value of such terms.
struct StableValues {
  OracleValues values = {};
  /// False: the digits do not distinguish it from 0, or a number is too large.
  bool is_decided = true;
};
inline constexpr unsigned max_stable_digits = 2000;

/// The entries of an output, by at least two evaluations.
[[nodiscard]] StableValues stable_values(const Model& model, const OutputRequest& output,
                                         const State& state);

/// The value of one expression, by at least two evaluations: one entry.
[[nodiscard]] StableValues stable_expression_value(const Model& model, ExpressionId expression,
                                                   const State& state);

/// d/ds of w.(M a + bias - B u) with dq/ds along x and dv/ds = y; a and u are constants of the
/// state. w, x and y have one entry per velocity; for a rotation x is a rotation vector in body
/// axes.
[[nodiscard]] std::optional<cln::cl_R> oracle_residual_slope(const Model& model, const State& state,
                                                             const std::vector<cln::cl_R>& w,
                                                             const std::vector<cln::cl_R>& x,
                                                             const std::vector<cln::cl_R>& y);

/// Directions that contract a field of an output: w.x for columns, w.(X y) for matrices. w has one
/// entry per row, y one per column; y is empty for columns.
struct Contraction {
  std::vector<cln::cl_R> w = {};
  std::vector<cln::cl_R> y = {};
  std::size_t field = 0;  ///< index of the field, in the order of the output table
};

/// The contraction of any field of any output. Cost: a few directional derivatives instead of all
/// entries. For energies, forward_dynamics, constraints and user outputs all entries are computed.
/// Meant for self-checks of large models.
[[nodiscard]] std::optional<cln::cl_R> oracle_contraction(const Model& model,
                                                          const OutputRequest& output,
                                                          const State& state,
                                                          const Contraction& by);

/// E| plus the magnitudes of the terms of V, in J: the scale of rounding errors in L.
[[nodiscard]] std::optional<cln::cl_R> oracle_energy_magnitude(const Model& model,
                                                               const State& state);

/// The result of Newton's method on the constraints.
struct Assembly {
  State state = {};
  bool has_pose = false;   ///< f = 0 to 60 digits of the coordinates
  bool has_rates = false;  ///< the rates are consistent with the pose
};

/// Coordinates and rates that the assembly must not change, by velocity. Empty: it may change all.
struct FixedVariables {
  std::vector<bool> positions = {};
  std::vector<bool> rates = {};
};

/// Newton steps as in `projected` from a state, halved until the residuals shrink; then the rates
/// are projected. None if an equation has no value at the state.
[[nodiscard]] std::optional<Assembly> oracle_assembly(const Model& model, const State& state,
                                                      const FixedVariables& kept = {});

/// The assembled state; none if it does not satisfy the constraints.
[[nodiscard]] std::optional<State> oracle_assembled(const Model& model, State state);

/// D_i / M_ii of a symmetric n x n matrix M = L D L^T, eliminated from the first row to the last.
/// Empty if a pivot is 0.
[[nodiscard]] OracleValues oracle_relative_pivots(std::vector<cln::cl_R> matrix, std::size_t n);

/// The value of one expression of the model (for [[expect]]), with all leaves from the state.
[[nodiscard]] std::optional<cln::cl_R> oracle_expression(const Model& model,
                                                         ExpressionId expression,
                                                         const State& state);

/// The derivative of an expression along a direction of all leaves. The expression contains no open
/// function.
[[nodiscard]] std::optional<cln::cl_R> oracle_directional_derivative(const Model& model,
                                                                     ExpressionId expression,
                                                                     const State& state,
                                                                     const State& direction);

/// d/dt of an expression in q, v, t along the motion with acceleration state.a (for `conserved`). p
/// and E in it follow from the motion, not from the state.
[[nodiscard]] std::optional<cln::cl_R> oracle_rate(const Model& model, ExpressionId expression,
                                                   const State& state);

/// True if the parameters of a state meet a condition.
[[nodiscard]] bool oracle_satisfies(const Model& model, const Condition& condition,
                                    const State& state);

/// The state of rest at a stated point. `state` gives the parameters, and the coordinates that the
/// point leaves free; inputs without a value are 0. None if a value is undefined.
[[nodiscard]] std::optional<State> oracle_rest_state(const Model& model, const StatedPoint& point,
                                                     State state);

}  // namespace elgen
