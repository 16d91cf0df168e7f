// Null space of a matrix of 60-digit numbers, by Gauss-Jordan elimination.
#pragma once

#include <cln/real.h>

#include <vector>

namespace elgen {

using Vector = std::vector<cln::cl_R>;

/// 1e-80: what is smaller beside other entries is a zero that the oracle's working digits rounded;
/// no two inertias of one model differ so much.
[[nodiscard]] const cln::cl_R& rounding_share();

/// The largest magnitude in each row of a matrix of n columns, row-major; 0 where that is rounding
/// beside the largest of all.
[[nodiscard]] Vector row_scales(const Vector& matrix, std::size_t n);

/// A basis of {x : A x = 0}. Entries below 1e-50 of their row's scale are what cancellation left of
/// zero; a row whose scale is 0 is zero. Each basis vector has one entry 1 where all the others
/// have 0; behind it is nothing.
[[nodiscard]] std::vector<Vector> null_space(const Vector& matrix, const Vector& row_scales);

}  // namespace elgen
