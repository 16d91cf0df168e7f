// Constraints at one state, from the equations of the Model: with f(q, t) = 0, r = df/dt of
// positions and phi(q, v, t) = 0, r = phi of velocities
//
//     A = dr/dv,   gamma = dr/dt at a = 0,
//     [ M  A^T ] [  a      ]   [ B u - bias                     ]
//     [ A   0  ] [ -lambda ] = [ -gamma - 2 zeta omega r - omega^2 f ]
//
// solved as a whole with pivoting, where the program eliminates M first.
#pragma once

#include <vector>

#include "oracle/mechanics.hpp"

namespace elgen::oracle {

/// f of positions, then r of all.
[[nodiscard]] std::vector<cln::cl_R> constraint_residual(const Model& model, const State& state);

/// A, m x n, row-major.
[[nodiscard]] std::vector<cln::cl_R> constraint_jacobian(const Model& model, const State& state);

/// Rates, then accelerations of all velocities from the independent ones. OutsideDomain if they do
/// not determine the others.
[[nodiscard]] std::vector<cln::cl_R> completed(const Model& model,
                                               const std::vector<std::uint32_t>& independent,
                                               const State& state);

/// gamma.
[[nodiscard]] std::vector<cln::cl_R> constraint_bias(const Model& model, const State& state);

/// gamma + 2 zeta omega r + omega^2 f, with A a where a is given: the slope of that along a change
/// of position and velocity.
[[nodiscard]] std::vector<cln::cl_R> stabilised_bias(const Model& model, const State& state);
[[nodiscard]] std::vector<cln::cl_R> stabilised_slope(const Model& model, const State& state,
                                                      const Displacement& along,
                                                      const Direction& a);

/// Slope of w.A^T lambda where q moves along x.
[[nodiscard]] cln::cl_R held_slope(const Model& model, const State& state, const Direction& w,
                                   const Direction& x, const std::vector<cln::cl_R>& multipliers);

/// x and y with M x = r + A^T y, A x = s, by Gaussian elimination of the whole with pivoting; for
/// n x n M and m x n A. OutsideDomain where the whole is singular.
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

/// D_i / S_ii of S = A M^-1 A^T = L D L^T.
[[nodiscard]] std::vector<cln::cl_R> pivots_of_constraints(const Model& model,
                                                           const ConstrainedSystem& system);

/// M and A of a state.
[[nodiscard]] ConstrainedSystem constrained_system(Mechanics& at);

/// The same, without constraints in the model's order of elimination.
[[nodiscard]] ConstrainedMotion response(Mechanics& at, const ConstrainedSystem& system,
                                         const std::vector<cln::cl_R>& r,
                                         const std::vector<cln::cl_R>& s);

/// a and lambda.
[[nodiscard]] ConstrainedMotion constrained_motion(Mechanics& at, const ConstrainedSystem& system);

/// The shortage of constraints: a direction with A x = s makes f of positions, or r of all, 0 to
/// first order.
struct Shortage {
  std::vector<Direction> rows = {};  ///< of A
  std::vector<cln::cl_R> s = {};     ///< -f or -r
};
[[nodiscard]] Shortage position_shortage(const Model& model, const State& state);
[[nodiscard]] Shortage rate_shortage(const Model& model, const State& state);

/// x with M x = A^T y, A x = s: the change of least kinetic energy, 0 along what is kept.
[[nodiscard]] Direction correction(const Model& model, const State& state, const Shortage& shortage,
                                   const std::vector<bool>& kept = {});

/// The state at q + N x, quaternions at length 1.
[[nodiscard]] State moved_by(const Model& model, State state, const Direction& x);

/// Coordinates, then rates, after one step of Newton: q + N dq, then v + dv there, both by
/// correction().
[[nodiscard]] std::vector<cln::cl_R> projected(const Model& model, const State& state);

/// Inputs, multipliers, and tau - B u - A^T lambda.
[[nodiscard]] std::vector<cln::cl_R> constrained_inverse(const Model& model, const State& state);

}  // namespace elgen::oracle
