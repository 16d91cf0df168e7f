// Solved columns: the entries of solutions x of M x = b that lose digits together, as one number:
// in the norm |D^1/2 x|, D the diagonal of M. A small entry beside large ones has no digits of its
// own. Under constraints M a = b + A^T y, A a = c, multipliers y have the lengths of the rows of
// A D^-1/2 for D^1/2.
#pragma once

#include <vector>

#include "verify/bounds/field_place.hpp"
#include "verify/bounds/oracle_cache.hpp"

namespace elgen {

struct SolvedColumn {
  std::vector<std::size_t> entries = {};  ///< of the field
  std::vector<Real> weights = {};         ///< one for each of them
};

/// The columns of a field; empty where nothing is solved for, or M has a diagonal that is not
/// positive. Cost: n contractions of M.
[[nodiscard]] std::vector<SolvedColumn> solved_columns(const FieldPlace& place,
                                                       OracleCache& oracle);

/// sqrt(sum (w_i x_i)^2) of a column.
[[nodiscard]] Real norm(const SolvedColumn& column, const std::vector<Real>& values);

}  // namespace elgen
