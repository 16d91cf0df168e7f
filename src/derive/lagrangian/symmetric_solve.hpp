// Symmetric linear systems M x = r by a straight-line LDL^T factorisation that skips zeros.
//
//     W_ij = M_ij - sum_{k<j} L_jk W_ik,   D_j = W_jj,   L_ij = W_ij / D_j
//     z = L^-1 r,   x = L^-T D^-1 z
//
// Rows are in the order of elimination. A dense M costs n^3/6 operations. Golub, Van Loan, Matrix
// Computations, 4th ed., sec. 4.1.2; Featherstone, Rigid Body Dynamics Algorithms (2008), sec. 6.5.
#pragma once

#include <cstdint>
#include <stdexcept>
#include <string>
#include <vector>

#include "derive/lagrangian/derivation.hpp"

namespace elgen {

/// The kind of rows of a symmetric system, for error messages.
enum class RowKind : std::uint8_t { velocities, constraints, inputs };

/// Thrown if a pivot is identically 0, so that the matrix is singular in every state.
struct ZeroPivot : std::domain_error {
  ZeroPivot(RowKind the_rows, std::size_t the_row, bool diagonal)
      : std::domain_error("zero pivot"), rows(the_rows), row(the_row), is_diagonal(diagonal) {}
  RowKind rows;
  std::size_t row;
  bool is_diagonal;  ///< true: M_ii itself is 0, not only the pivot D_i
};

class SymmetricSolver {
 public:
  /// `matrix` is n x n, row-major, positive definite, so that no pivoting is needed. `order` lists
  /// the rows of `matrix` in the order of elimination. Throws ZeroPivot.
  SymmetricSolver(Definitions& definitions, const RealVector& matrix,
                  std::vector<std::size_t> order, RowKind rows);

  /// x with M x = r; entries are definitions.
  [[nodiscard]] RealVector solve(const RealVector& right_side) {
    return backward_substitution(forward_substitution(right_side));
  }

  /// L^-1 r, in the order of elimination; entries are definitions.
  [[nodiscard]] RealVector forward_substitution(const RealVector& right_side);
  /// L^-T D^-1 z, indexed by row; z is in the order of elimination.
  [[nodiscard]] RealVector backward_substitution(const RealVector& z);

  /// 1 / D, in the order of elimination.
  [[nodiscard]] const RealVector& reciprocal_pivots() const { return reciprocals_; }

  /// D_i / M_ii, by row: 1 if row i is decoupled; <= 0 or about machine epsilon if M is singular.
  [[nodiscard]] RealVector relative_pivots() const;
  [[nodiscard]] RealVector diagonal() const;

 private:
  [[nodiscard]] std::string row_number(std::size_t i) const;
  [[nodiscard]] GiNaC::ex eliminated_entry(std::size_t i, std::size_t j);
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
  std::vector<std::size_t> order_;  ///< rows in the order of elimination
  RealVector matrix_;               ///< M, row-major
  RealVector lower_;                ///< L without its unit diagonal; L, W and D follow order_
  RealVector unscaled_;             ///< W = L D
  RealVector pivots_;               ///< D
  RealVector reciprocals_;          ///< 1 / D
};

/// 0 … size - 1.
[[nodiscard]] std::vector<std::size_t> identity_order(std::size_t size);

/// The velocities in the order in which M is eliminated. If `lagrangian.eliminates_last_first` is
/// set, the last velocity comes first, so that entries of M between two limbs, which are 0, stay 0.
[[nodiscard]] std::vector<std::size_t> velocity_elimination_order(const Derivation& derivation);

/// Solves M x = r + A^T y, A x = s (motion under constraints) without pivoting.
///
///     M = L D L^T,   W = L^-1 A^T,   S = A M^-1 A^T = W^T D^-1 W
///     z = L^-1 r,   S y = s - W^T D^-1 z,   x = L^-T D^-1 (z + W y)
///
/// Without constraints, M x = r is solved. The rounding error grows with the product of the
/// condition numbers of M and of the whole system, because S inherits the condition of M. Benzi,
/// Golub, Liesen, Numerical solution of saddle point problems, Acta Numerica 14 (2005), sec. 5.
class ConstrainedSolver {
 public:
  /// `mass` is n x n, `jacobian` m x n, row-major. Throws ZeroPivot.
  ConstrainedSolver(Derivation& derivation, const RealVector& mass, const RealVector& jacobian);

  struct Solution {
    RealVector x;  ///< n
    RealVector y;  ///< m, the multipliers
  };

  /// x and y for the right-hand sides r and s; entries are definitions.
  [[nodiscard]] Solution solve(const RealVector& r, const RealVector& s);

  /// The relative pivots of M by velocity, then the relative pivots of S by constraint.
  [[nodiscard]] RealVector relative_pivots() const;
  [[nodiscard]] RealVector relative_pivots_of_constraints() const;
  [[nodiscard]] RealVector diagonal() const;

 private:
  [[nodiscard]] RealVector schur_complement(const RealVector& jacobian);

  Definitions& definitions_;
  SymmetricSolver mass_;
  std::vector<RealVector> columns_ = {};  ///< W, a vector for each constraint
  std::vector<RealVector> scaled_ = {};   ///< D^-1 W
  SymmetricSolver constraints_;           ///< S; declared after W, from which it is computed
};

}  // namespace elgen
