// Pivots by the solver of the oracle, the right side being 0.
#include "verify/bounds/pivots.hpp"

#include <cln/exception.h>

#include <algorithm>

#include "oracle/linear_solve.hpp"
#include "oracle/real_functions.hpp"

namespace elgen {

std::optional<std::vector<Real>> relative_pivots(const std::vector<Real>& m, std::size_t n,
                                                 bool last_first) {
  std::vector<cln::cl_R> entries;
  for (const Real& entry : m) {
    if (entry.is_defined()) entries.push_back(entry.value());
  }
  if (entries.size() != n * n) return std::nullopt;
  if (last_first) std::reverse(entries.begin(), entries.end());
  std::vector<Real> pivots;
  try {
    const auto solution = oracle::solve_symmetric(std::move(entries), std::vector<cln::cl_R>(n));
    for (const cln::cl_R& pivot : solution.relative_pivots) pivots.emplace_back(pivot);
  } catch (const oracle::OutsideDomain&) {
    return std::nullopt;
  } catch (const cln::runtime_exception&) {
    return std::nullopt;
  }
  if (last_first) std::reverse(pivots.begin(), pivots.end());
  return pivots;
}

}  // namespace elgen
