// Newton's method: x -= J^-1 r(x), stopped by what rounding leaves of r.
//
// A residual of a few roundings in every step, always to one side, is a drift of the energy, so
// there is no tolerance: the iteration ends where r stops shrinking.
#include "simulate/steps/newton.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace elgen {
namespace {

constexpr double rounding_unit = std::numeric_limits<double>::epsilon();
constexpr int most_iterations = 50;
constexpr int most_jacobians = 10;

double largest(const Numbers& values) {
  double result = 0;
  // A NaN is the largest of all.
  for (const double value : values) result = std::abs(value) <= result ? result : std::abs(value);
  return result;
}

}  // namespace

bool Newton::solve(Numbers& x, const Residual& residual) {
  r_.resize(x.size());
  if (has_jacobian_ && iterate(x, residual)) return true;
  // A Jacobian far from the solution may lead near it.
  for (int attempt = 0; attempt < most_jacobians; ++attempt) {
    factorise(x, residual);
    if (iterate(x, residual)) return true;
  }
  has_jacobian_ = false;
  return false;
}

/// Column j: (r(x + d e_j) - r(x)) / d.
void Newton::factorise(Numbers& x, const Residual& residual) {
  const auto n = static_cast<Eigen::Index>(x.size());
  Eigen::MatrixXd matrix(n, n);
  (void)residual(x, r_);
  moved_.resize(x.size());
  const double size = largest(x);
  for (std::size_t j = 0; j < x.size(); ++j) {
    const double before = x[j];
    x[j] += std::sqrt(rounding_unit) * (size > 0 ? size : 1);
    (void)residual(x, moved_);
    for (std::size_t i = 0; i < x.size(); ++i) {
      matrix(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j)) =
          (moved_[i] - r_[i]) / (x[j] - before);
    }
    x[j] = before;
  }
  jacobian_.compute(matrix);
  has_jacobian_ = true;
}

bool Newton::iterate(Numbers& x, const Residual& residual) {
  double last = std::numeric_limits<double>::infinity();
  for (int i = 0; i < most_iterations; ++i) {
    const double scale = residual(x, r_);
    const double size = largest(r_);
    if (size == 0) return true;
    if (!(size < last / 2)) return size <= 1e3 * rounding_unit * scale;
    const Eigen::Map<const Eigen::VectorXd> r(r_.data(), static_cast<Eigen::Index>(r_.size()));
    Eigen::Map<Eigen::VectorXd>(x.data(), r.size()) -= jacobian_.solve(r);
    last = size;
  }
  return false;
}

}  // namespace elgen
