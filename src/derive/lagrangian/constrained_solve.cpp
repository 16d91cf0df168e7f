// The range-space method over definitions.
#include "derive/lagrangian/constrained_solve.hpp"

namespace elgen {

using GiNaC::ex;

namespace {

Vector joined(Vector first, const Vector& second) {
  first.insert(first.end(), second.begin(), second.end());
  return first;
}

ex product(const Vector& a, const Vector& b) {
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
          define(definitions_, product(columns_[i], scaled_[j]));
    }
  }
  return result;
}

ConstrainedSolve::Solution ConstrainedSolve::solve(const Vector& r, const Vector& s) {
  Vector z = mass_.forward(r);
  Vector right;
  for (std::size_t i = 0; i < columns_.size(); ++i) right.push_back(s[i] - product(scaled_[i], z));
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
  return joined(mass_.relative_pivots(), constraints_.relative_pivots());
}

Vector ConstrainedSolve::diagonal() const {
  return joined(mass_.diagonal(), constraints_.diagonal());
}

}  // namespace elgen
