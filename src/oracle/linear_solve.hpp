// Linear systems M x = r with symmetric M, by M = L D L^T in natural order without pivoting.
#pragma once

#include <cln/real.h>

#include <vector>

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

}  // namespace elgen::oracle
