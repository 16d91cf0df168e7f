// LDL^T over definitions: every entry of W, D, L and z is a definition. Constraints are solved by
// the range-space method.
#include "derive/lagrangian/symmetric_solve.hpp"

#include <algorithm>
#include <numeric>
#include <string>
#include <utility>

#include "derive/formulate/name_scope.hpp"

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
    const NameScope eliminated(definitions_, "pivot", row_of(j));
    pivots_.push_back(entry(j, j));
    if (pivots_[j].is_zero()) throw ZeroPivot(rows, order_[j], false);
    reciprocals_.push_back(define(definitions_, 1 / pivots_[j]));
    for (std::size_t i = j + 1; i < n; ++i) {
      const NameScope under_pivot(definitions_, "row", row_of(j) + "_" + row_of(i));
      unscaled(i, j) = entry(i, j);
      lower(i, j) = define(definitions_, unscaled(i, j) * reciprocals_[j]);
    }
  }
}

std::string SymmetricSolve::row_of(std::size_t i) const { return std::to_string(order_[i] + 1); }

ex SymmetricSolve::entry(std::size_t i, std::size_t j) {
  GiNaC::exvector terms{matrix(i, j)};
  for (std::size_t k = 0; k < j; ++k) terms.push_back(-lower(j, k) * unscaled(i, k));
  return define(definitions_, GiNaC::add(terms));
}

Vector SymmetricSolve::forward(const Vector& right_side) {
  Vector z(order_.size());
  for (std::size_t i = 0; i < z.size(); ++i) {
    const NameScope forwards(definitions_, "forward", row_of(i));
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
    const NameScope backwards(definitions_, "solution", row_of(i));
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

namespace {

Vector joined(Vector first, const Vector& second) {
  first.insert(first.end(), second.begin(), second.end());
  return first;
}

ex dot_product(const Vector& a, const Vector& b) {
  GiNaC::exvector terms;
  for (std::size_t i = 0; i < a.size(); ++i) terms.push_back(a[i] * b[i]);
  return GiNaC::add(terms);
}

}  // namespace

ConstrainedSolve::ConstrainedSolve(Derivation& derivation, const Vector& mass,
                                   const Vector& jacobian)
    : definitions_(derivation.definitions),
      mass_(definitions_, mass, order_of_velocities(derivation), RowsOf::velocities),
      constraints_(definitions_, complement(jacobian),
                   in_order(jacobian.size() / derivation.size()), RowsOf::constraints) {}

Vector ConstrainedSolve::complement(const Vector& jacobian) {
  const Vector& reciprocals = mass_.reciprocal_pivots();
  const std::size_t n = reciprocals.size();
  const std::size_t m = jacobian.size() / n;
  for (std::size_t row = 0; row < m; ++row) {
    const auto begin = jacobian.begin() + static_cast<std::ptrdiff_t>(row * n);
    columns_.push_back(mass_.forward({begin, begin + static_cast<std::ptrdiff_t>(n)}));
    Vector& scaled = scaled_.emplace_back();
    for (std::size_t k = 0; k < n; ++k) {
      scaled.push_back(define(definitions_, columns_[row][k] * reciprocals[k]));
    }
  }
  Vector result(m * m);
  for (std::size_t i = 0; i < m; ++i) {
    for (std::size_t j = 0; j <= i; ++j) {
      result[i * m + j] = result[j * m + i] =
          define(definitions_, dot_product(columns_[i], scaled_[j]));
    }
  }
  return result;
}

ConstrainedSolve::Solution ConstrainedSolve::solve(const Vector& r, const Vector& s) {
  Vector z = mass_.forward(r);
  Vector right;
  for (std::size_t i = 0; i < columns_.size(); ++i)
    right.push_back(s[i] - dot_product(scaled_[i], z));
  Solution solution{{}, constraints_.solve(right)};
  for (std::size_t k = 0; k < z.size(); ++k) {
    GiNaC::exvector terms{z[k]};
    for (std::size_t i = 0; i < columns_.size(); ++i) {
      terms.push_back(columns_[i][k] * solution.y[i]);
    }
    z[k] = define(definitions_, GiNaC::add(terms));
  }
  solution.x = mass_.backward(z);
  return solution;
}

Vector ConstrainedSolve::relative_pivots() const {
  return joined(mass_.relative_pivots(), relative_pivots_of_constraints());
}

Vector ConstrainedSolve::relative_pivots_of_constraints() const {
  return constraints_.relative_pivots();
}

Vector ConstrainedSolve::diagonal() const {
  return joined(mass_.diagonal(), constraints_.diagonal());
}

}  // namespace elgen
