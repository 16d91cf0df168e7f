// Constraints at one state, from the equations of the Model. Position constraints are f(q, t) = 0
// with r = df/dt, velocity constraints are phi(q, v, t) = 0 with r = phi.
//
//     A = dr/dv,   gamma = dr/dt at a = 0,
//     [ M  A^T ] [  a      ]   [ B u - bias                     ]
//     [ A   0  ] [ -lambda ] = [ -gamma - 2 zeta omega r - omega^2 f ]
//
// The oracle solves the whole system with pivoting. The derived program eliminates M first.
#pragma once

#include <vector>

#include "oracle/mechanics.hpp"

namespace elgen::oracle {

/// f of the position constraints, then r of all constraints.
[[nodiscard]] std::vector<cln::cl_R> constraint_residual(const Model& model, const State& state);

/// A, m x n row-major for m constraints and n velocities.
[[nodiscard]] std::vector<cln::cl_R> constraint_jacobian(const Model& model, const State& state);

/// All rates, then all accelerations, from the independent entries of v and a. OutsideDomain if A
/// does not determine the dependent entries.
[[nodiscard]] std::vector<cln::cl_R> complete_motion(const Model& model,
                                                     const std::vector<std::uint32_t>& independent,
                                                     const State& state);

/// gamma = dr/dt at a = 0, one entry per constraint.
[[nodiscard]] std::vector<cln::cl_R> constraint_bias(const Model& model, const State& state);

/// gamma + 2 zeta omega r + omega^2 f, one entry per constraint.
[[nodiscard]] std::vector<cln::cl_R> stabilised_bias(const Model& model, const State& state);
/// Derivative of A a + gamma + 2 zeta omega r + omega^2 f along `along`, a displacement of q and v,
/// at constant a.
[[nodiscard]] std::vector<cln::cl_R> stabilised_slope(const Model& model, const State& state,
                                                      const Displacement& along,
                                                      const Direction& a);

/// Derivative of w.A^T lambda along the displacement x of q, at constant lambda = `multipliers`.
[[nodiscard]] cln::cl_R constraint_force_slope(const Model& model, const State& state,
                                               const Direction& w, const Direction& x,
                                               const std::vector<cln::cl_R>& multipliers);

/// Solution of M x = r + A^T y, A x = s, for M n x n and A m x n. solve_constrained() eliminates
/// the whole matrix with pivoting; OutsideDomain if the matrix is singular.
struct ConstrainedMotion {
  std::vector<cln::cl_R> x = {};
  std::vector<cln::cl_R> y = {};
};
struct ConstrainedSystem {
  std::vector<cln::cl_R> mass = {};
  std::vector<cln::cl_R> jacobian = {};
};
[[nodiscard]] ConstrainedMotion solve_constrained(const ConstrainedSystem& system,
                                                  const std::vector<cln::cl_R>& r,
                                                  const std::vector<cln::cl_R>& s);

/// Relative pivots D_i / S_ii of S = A M^-1 A^T = L D L^T.
[[nodiscard]] std::vector<cln::cl_R> constraint_pivots(const Model& model,
                                                       const ConstrainedSystem& system);

/// M and A at a state.
[[nodiscard]] ConstrainedSystem constrained_system(Mechanics& at);

/// solve_constrained() of the system with right sides r and s. Without constraints x is from
/// solve_mass(), which eliminates in the model's order, and y is empty.
[[nodiscard]] ConstrainedMotion solve_response(Mechanics& at, const ConstrainedSystem& system,
                                               const std::vector<cln::cl_R>& r,
                                               const std::vector<cln::cl_R>& s);

/// The accelerations x = a and the multipliers y = lambda at the state of `at`.
[[nodiscard]] ConstrainedMotion constrained_motion(Mechanics& at, const ConstrainedSystem& system);

/// Linear equations A x = s. Each solution x is a displacement of the positions after which f = 0
/// to first order, or a change of the rates after which r = 0.
struct LinearisedConstraints {
  std::vector<Direction> rows = {};        ///< rows of A
  std::vector<cln::cl_R> right_side = {};  ///< -f of positions, or -r of rates
};
[[nodiscard]] LinearisedConstraints linearise_positions(const Model& model, const State& state);
[[nodiscard]] LinearisedConstraints linearise_rates(const Model& model, const State& state);

/// The solution x of A x = s with the least 1/2 x.M x, and with x_i = 0 for each `fixed` velocity
/// i. For every other velocity i, row i of M x = A^T y holds.
[[nodiscard]] Direction least_energy_correction(const Model& model, const State& state,
                                                const LinearisedConstraints& constraints,
                                                const std::vector<bool>& fixed = {});

/// The state at q + N x, with quaternions normalised.
[[nodiscard]] State displaced_state(const Model& model, State state, const Direction& x);

/// Coordinates, then rates, after one Newton step: q + N dq, then v + dv with dv computed at the
/// new position. dq and dv come from least_energy_correction().
[[nodiscard]] std::vector<cln::cl_R> project_state(const Model& model, const State& state);

/// Inverse dynamics with constraints: inputs u, multipliers lambda, and the residual tau - B u -
/// A^T lambda.
[[nodiscard]] std::vector<cln::cl_R> constrained_inverse_dynamics(const Model& model,
                                                                  const State& state);

}  // namespace elgen::oracle
