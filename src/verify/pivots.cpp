// L D L^T by columns: D_k = M_kk - sum_j L_kj^2 D_j, L_ik = (M_ik - sum_j L_ij L_kj D_j) / D_k.
#include "pivots.hpp"

#include <algorithm>

namespace elgen {
namespace {

/// M_ik - sum_{j < k} L_ij L_kj D_j, with L and D kept in the lower triangle of m.
Real reduced(const std::vector<Real>& m, std::size_t n, std::size_t i, std::size_t k) {
  Real entry = m[i * n + k];
  for (std::size_t j = 0; j < k; ++j) entry = entry - m[i * n + j] * m[k * n + j] * m[j * n + j];
  return entry;
}

}  // namespace

std::optional<std::vector<Real>> relative_pivots(std::vector<Real> m, std::size_t n,
                                                 bool last_first) {
  if (m.size() != n * n) return std::nullopt;
  if (last_first) std::reverse(m.begin(), m.end());
  std::vector<Real> pivots;
  for (std::size_t k = 0; k < n; ++k) {
    const Real diagonal = m[k * n + k];
    const Real pivot = reduced(m, n, k, k);
    const Real relative = pivot / diagonal;
    if (!relative.is_defined() || cln::zerop(pivot.value())) return std::nullopt;
    pivots.push_back(relative);
    m[k * n + k] = pivot;
    for (std::size_t i = k + 1; i < n; ++i) m[i * n + k] = reduced(m, n, i, k) / pivot;
  }
  if (last_first) std::reverse(pivots.begin(), pivots.end());
  return pivots;
}

}  // namespace elgen
