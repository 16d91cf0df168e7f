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

SymmetricSolver::SymmetricSolver(Definitions& definitions, const RealVector& matrix,
                                 std::vector<std::size_t> order, RowKind rows)
    : definitions_(definitions), order_(std::move(order)) {
  const std::size_t n = order_.size();
  for (const ex& value : matrix) matrix_.push_back(define(definitions_, value));
  lower_.assign(n * n, 0);
  unscaled_.assign(n * n, 0);
  for (std::size_t j = 0; j < n; ++j) {
    if (matrix_[j * n + j].is_zero()) throw ZeroPivot(rows, j, true);
  }
  for (std::size_t j = 0; j < n; ++j) {
    const NameScope eliminated(definitions_, "pivot", row_number(j));
    pivots_.push_back(eliminated_entry(j, j));
    if (pivots_[j].is_zero()) throw ZeroPivot(rows, order_[j], false);
    reciprocals_.push_back(define(definitions_, 1 / pivots_[j]));
    for (std::size_t i = j + 1; i < n; ++i) {
      const NameScope under_pivot(definitions_, "row", row_number(j) + "_" + row_number(i));
      unscaled(i, j) = eliminated_entry(i, j);
      lower(i, j) = define(definitions_, unscaled(i, j) * reciprocals_[j]);
    }
  }
}

std::string SymmetricSolver::row_number(std::size_t i) const {
  return std::to_string(order_[i] + 1);
}

ex SymmetricSolver::eliminated_entry(std::size_t i, std::size_t j) {
  GiNaC::exvector terms{matrix(i, j)};
  for (std::size_t k = 0; k < j; ++k) terms.push_back(-lower(j, k) * unscaled(i, k));
  return define(definitions_, GiNaC::add(terms));
}

RealVector SymmetricSolver::forward_substitution(const RealVector& right_side) {
  RealVector z(order_.size());
  for (std::size_t i = 0; i < z.size(); ++i) {
    const NameScope forwards(definitions_, "forward", row_number(i));
    GiNaC::exvector terms{right_side[order_[i]]};
    for (std::size_t k = 0; k < i; ++k) terms.push_back(-lower(i, k) * z[k]);
    z[i] = define(definitions_, GiNaC::add(terms));
  }
  return z;
}

RealVector SymmetricSolver::backward_substitution(const RealVector& z) {
  const std::size_t n = order_.size();
  RealVector x(n);
  for (std::size_t i = n; i-- > 0;) {
    const NameScope backwards(definitions_, "solution", row_number(i));
    GiNaC::exvector terms{z[i] * reciprocals_[i]};
    for (std::size_t k = i + 1; k < n; ++k) terms.push_back(-lower(k, i) * x[order_[k]]);
    x[order_[i]] = define(definitions_, GiNaC::add(terms));
  }
  return x;
}

RealVector SymmetricSolver::diagonal() const {
  RealVector result(order_.size());
  for (std::size_t i = 0; i < order_.size(); ++i) result[order_[i]] = matrix(i, i);
  return result;
}

RealVector SymmetricSolver::relative_pivots() const {
  RealVector result(order_.size());
  for (std::size_t i = 0; i < order_.size(); ++i) result[order_[i]] = pivots_[i] / matrix(i, i);
  return result;
}

std::vector<std::size_t> identity_order(std::size_t size) {
  std::vector<std::size_t> order(size);
  std::iota(order.begin(), order.end(), std::size_t{0});
  return order;
}

std::vector<std::size_t> velocity_elimination_order(const Derivation& derivation) {
  std::vector<std::size_t> order = identity_order(derivation.size());
  if (derivation.lagrangian.eliminates_last_first) std::reverse(order.begin(), order.end());
  return order;
}

namespace {

RealVector concatenate(RealVector first, const RealVector& second) {
  first.insert(first.end(), second.begin(), second.end());
  return first;
}

ex dot_product(const RealVector& a, const RealVector& b) {
  GiNaC::exvector terms;
  for (std::size_t i = 0; i < a.size(); ++i) terms.push_back(a[i] * b[i]);
  return GiNaC::add(terms);
}

}  // namespace

ConstrainedSolver::ConstrainedSolver(Derivation& derivation, const RealVector& mass,
                                     const RealVector& jacobian)
    : definitions_(derivation.definitions),
      mass_(definitions_, mass, velocity_elimination_order(derivation), RowKind::velocities),
      constraints_(definitions_, schur_complement(jacobian),
                   identity_order(jacobian.size() / derivation.size()), RowKind::constraints) {}

RealVector ConstrainedSolver::schur_complement(const RealVector& jacobian) {
  const RealVector& reciprocals = mass_.reciprocal_pivots();
  const std::size_t n = reciprocals.size();
  const std::size_t m = jacobian.size() / n;
  for (std::size_t row = 0; row < m; ++row) {
    const auto begin = jacobian.begin() + static_cast<std::ptrdiff_t>(row * n);
    columns_.push_back(mass_.forward_substitution({begin, begin + static_cast<std::ptrdiff_t>(n)}));
    RealVector& scaled = scaled_.emplace_back();
    for (std::size_t k = 0; k < n; ++k) {
      scaled.push_back(define(definitions_, columns_[row][k] * reciprocals[k]));
    }
  }
  RealVector result(m * m);
  for (std::size_t i = 0; i < m; ++i) {
    for (std::size_t j = 0; j <= i; ++j) {
      result[i * m + j] = result[j * m + i] =
          define(definitions_, dot_product(columns_[i], scaled_[j]));
    }
  }
  return result;
}

ConstrainedSolver::Solution ConstrainedSolver::solve(const RealVector& r, const RealVector& s) {
  RealVector z = mass_.forward_substitution(r);
  RealVector right;
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
  solution.x = mass_.backward_substitution(z);
  return solution;
}

RealVector ConstrainedSolver::relative_pivots() const {
  return concatenate(mass_.relative_pivots(), relative_pivots_of_constraints());
}

RealVector ConstrainedSolver::relative_pivots_of_constraints() const {
  return constraints_.relative_pivots();
}

RealVector ConstrainedSolver::diagonal() const {
  return concatenate(mass_.diagonal(), constraints_.diagonal());
}

}  // namespace elgen
