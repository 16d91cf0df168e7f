// Symmetric linear systems M x = r by a straight-line LDL^T factorisation, zeros skipped.
//
//     W_ij = M_ij - sum_{k<j} L_jk W_ik,   D_j = W_jj,   L_ij = W_ij / D_j
//     z = L^-1 r,   x = L^-T D^-1 z
//
// in the order of elimination. Where frames branch that is from the last velocity to the first, so
// that a limb is eliminated before what carries it, and no entry between two limbs fills in.
// n^3/6 operations for a dense M. Golub, Van Loan, Matrix Computations, 4th ed., sec. 4.1.2;
// Featherstone, Rigid Body Dynamics Algorithms (2008), sec. 6.5.
#pragma once

#include <stdexcept>

#include "derive/lagrangian/derivation.hpp"

namespace elgen {

/// Thrown where M cannot be factorised whatever the state is: by the elimination of this velocity.
struct ZeroPivot : std::domain_error {
  ZeroPivot(std::size_t the_velocity, bool diagonal)
      : std::domain_error("zero pivot"), velocity(the_velocity), is_diagonal(diagonal) {}
  std::size_t velocity;
  bool is_diagonal;  ///< M_ii itself is 0, not only what the elimination leaves of it
};

class SymmetricSolve {
 public:
  /// `matrix` is n x n, row-major. Without pivoting: M is positive definite. Throws ZeroPivot.
  SymmetricSolve(Derivation& derivation, const Vector& matrix);

  /// x with M x = r; entries are definitions.
  [[nodiscard]] Vector solve(const Vector& right_side);

  /// D_i / M_ii by velocity: 1 where decoupled, <= 0 or about epsilon where M is singular.
  [[nodiscard]] Vector relative_pivots() const;
  [[nodiscard]] Vector diagonal() const;

 private:
  [[nodiscard]] GiNaC::ex entry(std::size_t i, std::size_t j);
  [[nodiscard]] const GiNaC::ex& matrix(std::size_t i, std::size_t j) const {
    return matrix_[order_[i] * order_.size() + order_[j]];
  }
  [[nodiscard]] GiNaC::ex& lower(std::size_t i, std::size_t j) {
    return lower_[i * order_.size() + j];
  }
  [[nodiscard]] GiNaC::ex& unscaled(std::size_t i, std::size_t j) {
    return unscaled_[i * order_.size() + j];
  }

  Definitions& definitions_;
  std::vector<std::size_t> order_;  ///< velocities in the order of elimination
  Vector matrix_;                   ///< by velocities
  Vector lower_;                    ///< L, unit diagonal not stored; from here on by order
  Vector unscaled_;                 ///< W = L D
  Vector pivots_;                   ///< D
  Vector reciprocals_;              ///< 1 / D
};

}  // namespace elgen
