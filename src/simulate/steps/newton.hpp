// Newton's method with a Jacobian of differences, which is kept while it serves.
#pragma once

#include <Eigen/LU>
#include <functional>

#include "simulate/steps/system.hpp"

namespace elgen {

class Newton {
 public:
  /// Fills r(x); the magnitude of what cancels in r where x solves it.
  using Residual = std::function<double(const Numbers& x, Numbers& r)>;

  /// r(x) = 0 from x on, as exactly as r can be computed: until it does not get smaller. False
  /// where that is not small, or no number. Cost: about four calls of r, and one more per unknown
  /// where the last Jacobian does not serve.
  [[nodiscard]] bool solve(Numbers& x, const Residual& residual);

  /// Before another problem.
  void forget() { has_jacobian_ = false; }

 private:
  void factorise(Numbers& x, const Residual& residual);
  [[nodiscard]] bool iterate(Numbers& x, const Residual& residual);

  Eigen::PartialPivLU<Eigen::MatrixXd> jacobian_ = {};
  bool has_jacobian_ = false;
  Numbers r_ = {};
  Numbers moved_ = {};
};

}  // namespace elgen
