// M a = B u - bias, solved: what forward dynamics and its derivatives start from.
#pragma once

#include "oracle/linear_solve.hpp"
#include "oracle/mechanics.hpp"

namespace elgen::oracle {

/// M, n x n for n velocities, row-major.
[[nodiscard]] std::vector<cln::cl_R> mass_matrix_values(Mechanics& at);

/// M x = r with M at hand, and the relative pivots by velocity, in the model's order of
/// elimination.
[[nodiscard]] Solution solve_mass(const Model& model, std::vector<cln::cl_R> mass,
                                  const std::vector<cln::cl_R>& right_side);

/// The acceleration and the relative pivots, each of one entry per velocity.
[[nodiscard]] Solution solved_dynamics(Mechanics& at, const std::vector<cln::cl_R>& mass);

}  // namespace elgen::oracle
