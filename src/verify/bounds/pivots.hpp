// Pivots of M = L D L^T without exchanges.
#pragma once

#include <optional>
#include <vector>

#include "elgen/evaluate.hpp"

namespace elgen {

/// D_i / M_ii for the symmetric n x n matrix m, eliminated from the first row to the last or back;
/// none where an entry is undefined or a pivot is exactly 0.
[[nodiscard]] std::optional<std::vector<Real>> relative_pivots(const std::vector<Real>& m,
                                                               std::size_t n,
                                                               bool last_first = false);

}  // namespace elgen
