// SPDX-License-Identifier: 0BSD
// Moves an arm with unknown masses and inertias along a path and learns the parameters (Slotine,
// Li, International Journal of Robotics Research 6(3), 1987). With e = q - q_r,
// r = v_r - L e, s = v - r:
//     tau = Y_r(q, v, r, dr/dt) pi - K s,   dpi/dt = -G Y_r^T s
// The function 1/2 s.M s + 1/2 (pi - true).G^-1 (pi - true) decreases at the rate s.K s, because
// dM/dt - 2 C is skew-symmetric.
#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <cstdio>

#include "two_link_arm_adapt/two_link_arm_adapt_eigen.hpp"

namespace arm = two_link_arm_adapt;
using Eigen::Vector2d;
using Eigen::Vector4d;

struct Motion {
  Vector2d x, v, a;
};

/// A path with several frequencies, so that all parameters can be identified.
Motion reference(double t) {
  Motion wanted{Vector2d::Zero(), Vector2d::Zero(), Vector2d::Zero()};
  const double rates[2][2] = {{1.1, 2.9}, {1.7, 4.3}};
  for (int joint = 0; joint < 2; ++joint) {
    for (const double w : rates[joint]) {
      wanted.x[joint] += 0.6 * std::sin(w * t);
      wanted.v[joint] += 0.6 * w * std::cos(w * t);
      wanted.a[joint] -= 0.6 * w * w * std::sin(w * t);
    }
  }
  return wanted;
}

int main() {
  const arm::Parameters<double> real{};
  const Vector4d truth = arm::eigen::regressor_parameters(real);
  Vector4d parameters = 0.5 * truth;
  const Vector4d gains(2, 0.2, 1, 0.1);
  const double h = 1e-3, l = 10, k = 8;
  Motion wanted = reference(0);
  Vector2d q = wanted.x, v = wanted.v;
  double at_first = 0, at_last = 0;
  for (int sample = 1; sample <= 60000; ++sample) {
    const Vector2d r = wanted.v - l * (q - wanted.x);
    const Vector2d rate = wanted.a - l * (v - wanted.v);
    const Vector2d s = v - r;
    const auto y = arm::eigen::regressor_reference(real, q, v, r, rate);
    const Vector2d torque = y.matrix * parameters + y.rest - k * s;
    parameters -= h * gains.cwiseProduct(y.matrix.transpose() * s);
    const auto next = arm::eigen::step(real, q, v, torque, h);
    q = next.coordinates;
    v = next.rates;
    wanted = reference(sample * h);
    const double error = (wanted.x - q).cwiseAbs().maxCoeff();
    double& largest = sample <= 5000 ? at_first : at_last;
    if (sample <= 5000 || sample > 55000) largest = std::max(error, largest);  // max(NaN, x) is NaN
  }
  const double wrong = ((parameters - truth).cwiseQuotient(truth)).cwiseAbs().maxCoeff();
  std::printf("off by at most %.1e rad in the first 5 s, by %.1e rad in the last\n", at_first,
              at_last);
  std::printf("masses and inertias within %.1f %%, from half of them\n", 100 * wrong);
  return at_last <= 1e-3 && wrong <= 0.02 ? 0 : 1;
}
