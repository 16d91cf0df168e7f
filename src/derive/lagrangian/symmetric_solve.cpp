// LDL^T over definitions: every W, D, L and z is one.
#include "derive/lagrangian/symmetric_solve.hpp"

#include <algorithm>
#include <numeric>
#include <utility>

namespace elgen {

using GiNaC::ex;

SymmetricSolve::SymmetricSolve(Definitions& definitions, const Vector& matrix,
                               std::vector<std::size_t> order, RowsOf rows)
    : definitions_(definitions), order_(std::move(order)) {
  const std::size_t n = order_.size();
  for (const ex& value : matrix) matrix_.push_back(define(definitions_, value));
  lower_.assign(n * n, 0);
  unscaled_.assign(n * n, 0);
  for (std::size_t j = 0; j < n; ++j) {
    if (matrix_[j * n + j].is_zero()) throw ZeroPivot(rows, j, true);
  }
  for (std::size_t j = 0; j < n; ++j) {
    pivots_.push_back(entry(j, j));
    if (pivots_[j].is_zero()) throw ZeroPivot(rows, order_[j], false);
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

Vector SymmetricSolve::forward(const Vector& right_side) {
  Vector z(order_.size());
  for (std::size_t i = 0; i < z.size(); ++i) {
    GiNaC::exvector terms{right_side[order_[i]]};
    for (std::size_t k = 0; k < i; ++k) terms.push_back(-lower(i, k) * z[k]);
    z[i] = define(definitions_, GiNaC::add(terms));
  }
  return z;
}

Vector SymmetricSolve::backward(const Vector& z) {
  const std::size_t n = order_.size();
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

std::vector<std::size_t> in_order(std::size_t size) {
  std::vector<std::size_t> order(size);
  std::iota(order.begin(), order.end(), std::size_t{0});
  return order;
}

std::vector<std::size_t> order_of_velocities(const Derivation& derivation) {
  std::vector<std::size_t> order = in_order(derivation.size());
  if (derivation.lagrangian.eliminates_last_first) std::reverse(order.begin(), order.end());
  return order;
}

}  // namespace elgen
