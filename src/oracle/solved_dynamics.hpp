// M a = B u - bias, solved for forward dynamics and its derivatives. M = L D L^T in natural order
// without pivoting. Also: the velocities v that belong to momenta p = M v + b, b = dL/dv at rest,
// and the rates dp/dt.
#pragma once

#include <cln/real.h>

#include <vector>

#include "oracle/mechanics.hpp"

namespace elgen::oracle {

struct SymmetricSolution {
  std::vector<cln::cl_R> x = {};
  std::vector<cln::cl_R> relative_pivots = {};  ///< D_i / M_ii, in (0, 1] if M is positive definite
};

/// Solves M x = `right_side` for M = `matrix`, n x n row-major; only the lower triangle is read.
/// OutsideDomain if |D_i / M_ii| of a pivot is below 1e-75.
[[nodiscard]] SymmetricSolution solve_symmetric(std::vector<cln::cl_R> matrix,
                                                const std::vector<cln::cl_R>& right_side);

/// Solves M x = r in the model's order of elimination. The relative pivots are in the order of the
/// velocities.
[[nodiscard]] SymmetricSolution solve_mass(const Model& model, std::vector<cln::cl_R> mass,
                                           const std::vector<cln::cl_R>& right_side);

[[nodiscard]] std::vector<cln::cl_R> negate(std::vector<cln::cl_R> values);

/// B u - bias.
[[nodiscard]] std::vector<cln::cl_R> net_forces(Mechanics& at);

/// x_i = e_i.x for each unit vector e_i.
[[nodiscard]] std::vector<cln::cl_R> unit_products(
    Mechanics& at, cln::cl_R (Mechanics::*product)(const Direction&));

/// M^-1 (p - b) at the position and time of a state. OutsideDomain if M is singular. Cost: the mass
/// matrix and one solve.
[[nodiscard]] std::vector<cln::cl_R> velocities_of_momenta(const Model& model, State state,
                                                           const std::vector<cln::cl_R>& p);

/// dp/dt = dL/dq + B u + Q - dD/dv; for angular velocities, - [omega]x dL/domega is added.
[[nodiscard]] std::vector<cln::cl_R> momentum_rates(const Model& model, const State& state);

/// B = dQ/du: n x m for n velocities and m inputs, row-major.
[[nodiscard]] std::vector<cln::cl_R> input_matrix_entries(Mechanics& at);

}  // namespace elgen::oracle
