// Oracle: 60-digit values of every output, straight from the energies of the Model. Texts name this
// precision alone: the oracle works in more digits (oracle/real_functions.hpp) and Real has 64.
//
// THIS CODE IS SLOW ON PURPOSE. Nested dual numbers on the Model's own expressions, nothing shared
// with the derivation, so that the two can be compared. Equations as defined (v = dq/dt):
//
//     tau = d/dt dL/dv - dL/dq + dD/dv - Q,   M = d2L/dv2,   h = C v from the Christoffel symbols
//     of M, C e_j = 1/2 (h(v + e_j) - h(v) - h(e_j)),  C_ij = 1/2 dh_i/dv_j, drift = bias - C v - g
//     - dD/dv + Q,   E = sum v dL/dv - L.
//
// Where velocities are angular, dq/dt = N(q) v: derivatives by q are along N, and d/dt dL/dv and C
// have the terms of mechanics.hpp.
#pragma once

#include <cln/float.h>
#include <cln/real.h>

#include <optional>
#include <vector>

#include "elgen/leaves.hpp"
#include "elgen/model.hpp"
#include "elgen/scene.hpp"

namespace elgen {

/// A point of evaluation, each number in the unit that the model declares; exact (rational) where
/// it comes from a binary or decimal input.
using State = LeafValues<cln::cl_R>;

/// Parameters at their values (or as fixed by the scene), quaternions at (1, 0, 0, 0), everything
/// else zero, sized for the model.
[[nodiscard]] State nominal_state(const Model& model, const Scene& scene);

/// The same at the `start` of coordinates and rates.
[[nodiscard]] State start_state(const Model& model, const Scene& scene);

/// Replaces every quaternion by a rational one of length 1, made of its last three components.
void make_unit_quaternions(const Model& model, State& state);

/// Values of one field after another, row-major, of the shape and in the units of the output table;
/// empty where an intermediate left the domain (sqrt(-1), 1/0).
using OracleValues = std::optional<std::vector<cln::cl_R>>;

/// All entries of an output, field by field as in the output table.
[[nodiscard]] OracleValues oracle_values(const Model& model, const OutputRequest& output,
                                         const State& state);

/// Values whose first 60 digits stay if they are computed in more. A value is 0 if it is exactly 0,
/// or rounding in so many digits that a value of terms of this size would show.
struct SettledValues {
  OracleValues values = {};
  bool is_told = true;  ///< false: the digits do not tell it from 0, or a number is too large
};
inline constexpr unsigned most_settled_digits = 2000;

/// All entries of an output, by two evaluations or more.
[[nodiscard]] SettledValues settled_values(const Model& model, const OutputRequest& output,
                                           const State& state);

/// Likewise of one expression of the model: one entry.
[[nodiscard]] SettledValues settled_expression(const Model& model, ExpressionId expression,
                                               const State& state);

/// Slope of w . (M a + bias - B u) where q moves along x and v along y; a and u are the state's and
/// stay; w, x, y have one entry per velocity. For a rotation x is its rotation vector in its axes.
[[nodiscard]] std::optional<cln::cl_R> oracle_residual_slope(const Model& model, const State& state,
                                                             const std::vector<cln::cl_R>& w,
                                                             const std::vector<cln::cl_R>& x,
                                                             const std::vector<cln::cl_R>& y);

/// Directions a field of an output is contracted with: w . x for columns, w . X y for matrices; w
/// has one entry per row, y one per column, or none for columns.
struct Contraction {
  std::vector<cln::cl_R> w = {};
  std::vector<cln::cl_R> y = {};
  std::size_t field = 0;  ///< of the output's, in the order of the output table
};

/// The contraction of any field of any output, at the cost of a few directional derivatives instead
/// of all entries (energies, forward_dynamics, constraints and user outputs: of all entries). For
/// self-checks of large models.
[[nodiscard]] std::optional<cln::cl_R> oracle_contraction(const Model& model,
                                                          const OutputRequest& output,
                                                          const State& state,
                                                          const Contraction& by);

/// |E| and the magnitudes of the terms that V sums, in J, in whose rounding what cancels drowns.
[[nodiscard]] std::optional<cln::cl_R> oracle_energy_magnitude(const Model& model,
                                                               const State& state);

/// Where Newton's method for the constraints ends.
struct Assembly {
  State state = {};
  bool has_pose = false;   ///< f is 0 there, to 60 digits of the coordinates
  bool has_rates = false;  ///< and the rates are consistent with it
};

/// The part of a state that an assembly keeps, by velocity: displacements along it, and rates.
/// Empty: nothing.
struct KeptStart {
  std::vector<bool> positions = {};
  std::vector<bool> rates = {};
};

/// From a state, by steps as in `projected` which are halved where they would lead away, then the
/// rates. None where an equation has no value at the state.
[[nodiscard]] std::optional<Assembly> oracle_assembly(const Model& model, const State& state,
                                                      const KeptStart& kept = {});

/// The state it ends at; none where the constraints do not hold there.
[[nodiscard]] std::optional<State> oracle_assembled(const Model& model, State state);

/// D_i / M_ii of a symmetric n x n matrix M = L D L^T, eliminated from the first row to the last.
/// Empty where a pivot is lost.
[[nodiscard]] OracleValues oracle_relative_pivots(std::vector<cln::cl_R> matrix, std::size_t n);

/// The value of one expression of the model (for [[expect]]); all its leaves are those of the
/// state.
[[nodiscard]] std::optional<cln::cl_R> oracle_expression(const Model& model,
                                                         ExpressionId expression,
                                                         const State& state);

/// The derivative of an expression, that names no open function, where all leaves move along a
/// direction.
[[nodiscard]] std::optional<cln::cl_R> oracle_slope(const Model& model, ExpressionId expression,
                                                    const State& state, const State& direction);

/// d/dt of an expression in q, v, t along the motion with acceleration state.a (for `conserved`);
/// p and E in it are those of the motion, whatever the state says.
[[nodiscard]] std::optional<cln::cl_R> oracle_rate(const Model& model, ExpressionId expression,
                                                   const State& state);

/// Whether the parameters of a state meet a condition.
[[nodiscard]] bool oracle_meets(const Model& model, const Condition& condition, const State& state);

/// A state at rest at a point, with the parameters given and the coordinates that the point leaves
/// open; inputs are 0 where it gives none. None where one of its values does not exist.
[[nodiscard]] std::optional<State> oracle_point(const Model& model, const StatedPoint& point,
                                                State state);

}  // namespace elgen
