// Factorised: a symmetric matrix M of values of a composition, as L D L^T, and what it is solved
// for.
//
//     W_ij = M_ij - sum_{k<j} L_jk W_ik,   D_j = W_jj,   L_ij = W_ij / D_j
//     z = L^-1 r,   x = L^-T D^-1 z
//
// n^3/6 operations without those on zeros. Where frames branch the last row goes first, so that
// zeros stay (derive/lagrangian/symmetric_solve.hpp has the same on formulas).
#pragma once

#include "elgen/model.hpp"
#include "program/steps/composition.hpp"

namespace elgen {

class Factorised {
 public:
  /// `mass`: n x n, row-major, of `model`. Without pivoting: M is positive definite.
  Factorised(Composition& compose, const Model& model, const Places& mass);

  /// x with M x = r.
  [[nodiscard]] Places solve(const Places& r);

 private:
  [[nodiscard]] std::uint32_t less(std::uint32_t value, std::uint32_t x, std::uint32_t y);

  Composition& compose_;
  Places order_ = {};               ///< rows of M as they are eliminated
  std::vector<Places> lower_ = {};  ///< L below its diagonal, by order
  Places reciprocals_ = {};         ///< 1 / D
};

}  // namespace elgen
