// Pivots of M = L D L^T in natural order, without exchanges.
#pragma once

#include <optional>
#include <vector>

#include "elgen/evaluate.hpp"

namespace elgen {

/// D_i / M_ii for the n x n row-major matrix m, of which the lower triangle is read; none where an
/// entry is undefined or a pivot is exactly 0.
[[nodiscard]] std::optional<std::vector<Real>> relative_pivots(std::vector<Real> m, std::size_t n);

}  // namespace elgen
