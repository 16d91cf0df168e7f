// Null space of a matrix of 60-digit numbers, by Gauss-Jordan elimination.
#pragma once

#include <cln/real.h>

#include <vector>

namespace elgen {

using RealVector = std::vector<cln::cl_R>;

/// 1e-80. An entry that is smaller than this multiple of the largest entry is rounding error of the
/// oracle, because inertias of one model do not differ by a factor of 1e80.
[[nodiscard]] const cln::cl_R& rounding_tolerance();

/// The largest magnitude in each row of a row-major matrix with n columns; 0 if this magnitude is
/// rounding error relative to the whole matrix.
[[nodiscard]] RealVector row_scales(const RealVector& matrix, std::size_t n);

/// A basis of {x : A x = 0}. Entries below 1e-50 times the scale of their row count as 0, because
/// they are left over from cancellation; a row with scale 0 counts as 0. The basis is in reduced
/// column echelon form: the last non-zero entry of each vector is 1, and all other vectors are 0 in
/// this component.
[[nodiscard]] std::vector<RealVector> null_space(const RealVector& matrix,
                                                 const RealVector& row_scales);

}  // namespace elgen
