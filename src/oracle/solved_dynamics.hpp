// M a = B u - bias, solved: what forward dynamics and its derivatives start from. M = L D L^T in
// natural order without pivoting. Momenta p = M v + b, b = dL/dv at rest: the velocities that they
// give, and their rates.
#pragma once

#include <cln/real.h>

#include <vector>

#include "oracle/mechanics.hpp"

namespace elgen::oracle {

struct Solution {
  std::vector<cln::cl_R> x = {};
  std::vector<cln::cl_R> relative_pivots =
      {};  ///< D_i / M_ii, in (0, 1] where M is positive definite
};

/// `matrix` is n x n, row-major; only its lower triangle is read. OutsideDomain where a pivot is
/// lost.
[[nodiscard]] Solution solve_symmetric(std::vector<cln::cl_R> matrix,
                                       const std::vector<cln::cl_R>& right_side);

/// M x = r with M at hand, and the relative pivots by velocity, in the model's order of
/// elimination.
[[nodiscard]] Solution solve_mass(const Model& model, std::vector<cln::cl_R> mass,
                                  const std::vector<cln::cl_R>& right_side);

[[nodiscard]] std::vector<cln::cl_R> negative(std::vector<cln::cl_R> values);

/// B u - bias.
[[nodiscard]] std::vector<cln::cl_R> moving_forces(Mechanics& at);

/// x_i = e_i.x of each unit direction.
[[nodiscard]] std::vector<cln::cl_R> unit_products(
    Mechanics& at, cln::cl_R (Mechanics::*product)(const Direction&));

/// M^-1 (p - b) at the position and time of a state. OutsideDomain where M is singular. Cost: the
/// mass matrix and one solve.
[[nodiscard]] std::vector<cln::cl_R> velocities_of_momenta(const Model& model, State state,
                                                           const std::vector<cln::cl_R>& p);

/// dL/dq + B u + Q - dD/dv at a state, and for angular velocities - [w]x dL/dw.
[[nodiscard]] std::vector<cln::cl_R> momentum_rates(const Model& model, const State& state);

/// B = dQ/du: n x m for n velocities and m inputs, row-major.
[[nodiscard]] std::vector<cln::cl_R> input_entries(Mechanics& at);

}  // namespace elgen::oracle
