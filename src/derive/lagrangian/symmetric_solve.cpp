// LDL^T over definitions: every W, D, L and z is one.
#include "derive/lagrangian/symmetric_solve.hpp"

#include <algorithm>
#include <numeric>

namespace elgen {

using GiNaC::ex;

SymmetricSolve::SymmetricSolve(Derivation& derivation, const Vector& matrix)
    : definitions_(derivation.definitions), order_(derivation.size()) {
  std::iota(order_.begin(), order_.end(), std::size_t{0});
  if (derivation.lagrangian.eliminates_last_first) std::reverse(order_.begin(), order_.end());
  const std::size_t n = order_.size();
  for (const ex& value : matrix) matrix_.push_back(define(definitions_, value));
  lower_.assign(n * n, 0);
  unscaled_.assign(n * n, 0);
  for (std::size_t j = 0; j < n; ++j) {
    if (matrix_[j * n + j].is_zero()) throw ZeroPivot(j, true);
  }
  for (std::size_t j = 0; j < n; ++j) {
    pivots_.push_back(entry(j, j));
    if (pivots_[j].is_zero()) throw ZeroPivot(order_[j], false);
    reciprocals_.push_back(define(definitions_, 1 / pivots_[j]));
    for (std::size_t i = j + 1; i < n; ++i) {
      unscaled(i, j) = entry(i, j);
      lower(i, j) = define(definitions_, unscaled(i, j) * reciprocals_[j]);
    }
  }
}

ex SymmetricSolve::entry(std::size_t i, std::size_t j) {
  GiNaC::exvector terms{matrix(i, j)};
  for (std::size_t k = 0; k < j; ++k) terms.push_back(-lower(j, k) * unscaled(i, k));
  return define(definitions_, GiNaC::add(terms));
}

Vector SymmetricSolve::solve(const Vector& right_side) {
  const std::size_t n = order_.size();
  Vector z(n);
  for (std::size_t i = 0; i < n; ++i) {
    GiNaC::exvector terms{right_side[order_[i]]};
    for (std::size_t k = 0; k < i; ++k) terms.push_back(-lower(i, k) * z[k]);
    z[i] = define(definitions_, GiNaC::add(terms));
  }
  Vector x(n);
  for (std::size_t i = n; i-- > 0;) {
    GiNaC::exvector terms{z[i] * reciprocals_[i]};
    for (std::size_t k = i + 1; k < n; ++k) terms.push_back(-lower(k, i) * x[order_[k]]);
    x[order_[i]] = define(definitions_, GiNaC::add(terms));
  }
  return x;
}

Vector SymmetricSolve::diagonal() const {
  Vector result(order_.size());
  for (std::size_t i = 0; i < order_.size(); ++i) result[order_[i]] = matrix(i, i);
  return result;
}

Vector SymmetricSolve::relative_pivots() const {
  Vector result(order_.size());
  for (std::size_t i = 0; i < order_.size(); ++i) result[order_[i]] = pivots_[i] / matrix(i, i);
  return result;
}

}  // namespace elgen
