// Forward dynamics: a = M^-1 (B u - bias) by a straight-line LDL^T factorisation.
#pragma once

#include "derive/derivation.hpp"

namespace elgen {

struct ForwardDynamics {
  Vector acceleration;
  Vector relative_pivots;  ///< D_i / M_ii: 1 where decoupled, <= 0 or about epsilon where M is
                           ///< singular
};

/// M = L D L^T without pivoting (M is positive definite), zeros skipped:
///
///     W_ij = M_ij - sum_{k<j} L_jk W_ik,   D_j = W_jj,   L_ij = W_ij / D_j
///     z = L^-1 (B u - bias),   a = L^-T D^-1 z
///
/// n^3/6 operations for a dense M. Golub, Van Loan, Matrix Computations, 4th ed., sec. 4.1.2.
[[nodiscard]] ForwardDynamics forward_dynamics(Derivation& derivation);

}  // namespace elgen
