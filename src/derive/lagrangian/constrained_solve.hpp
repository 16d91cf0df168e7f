// Motions under constraints: M x = r + A^T y, A x = s, without pivoting.
//
//     M = L D L^T,   W = L^-1 A^T,   S = A M^-1 A^T = W^T D^-1 W
//     z = L^-1 r,   S y = s - W^T D^-1 z,   x = L^-T D^-1 (z + W y)
//
// Without constraints it is M x = r. Where M is ill-conditioned, S inherits it: the error is that
// of the condition numbers of M and of the whole system multiplied. Benzi, Golub, Liesen, Numerical
// solution of saddle point problems, Acta Numerica 14 (2005), sec. 5.
#pragma once

#include "derive/lagrangian/symmetric_solve.hpp"

namespace elgen {

class ConstrainedSolve {
 public:
  /// `mass` is n x n, `jacobian` m x n, row-major. Throws ZeroPivot.
  ConstrainedSolve(Derivation& derivation, const Vector& mass, const Vector& jacobian);

  struct Solution {
    Vector x;  ///< n
    Vector y;  ///< m, the multipliers
  };

  /// Entries are definitions.
  [[nodiscard]] Solution solve(const Vector& r, const Vector& s);

  /// Those of M by velocity, then those of S by constraint.
  [[nodiscard]] Vector relative_pivots() const;
  [[nodiscard]] Vector diagonal() const;

 private:
  [[nodiscard]] Vector complement(const Vector& jacobian);

  Definitions& definitions_;
  SymmetricSolve mass_;
  std::vector<Vector> columns_ = {};  ///< W, a vector for each constraint
  std::vector<Vector> scaled_ = {};   ///< D^-1 W
  SymmetricSolve constraints_;        ///< S; after W, which it is made of
};

}  // namespace elgen
