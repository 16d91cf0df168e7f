// SPDX-License-Identifier: 0BSD
// Swings up a hanging pole and balances it, with a controller that samples at 1 kHz. The swing-up
// uses energy control (Astrom, Furuta, Swinging up a pendulum by energy control, 2000). With
//     E = 1/2 m l^2 dtheta^2 + m g l (cos(theta) - 1),   dE/dt = -m l cos(theta) dtheta ddx,
// a cart acceleration ddx with the sign of E cos(theta) dtheta drives E to 0, the energy at rest
// upright. Near the upright position the linear feedback u = -K x takes over (lqr.hpp).
#include <algorithm>
#include <cmath>
#include <cstdio>

#include "cart_pole_balance/cart_pole_balance_eigen.hpp"
#include "lqr.hpp"

namespace plant = cart_pole_balance;
using Force = plant::eigen::Vector<double, 1>;
constexpr double pi = 3.141592653589793;

struct State {
  Eigen::Vector2d q{0, pi}, v{0, 0};  // at rest, hanging
  double angle() const { return std::remainder(q[1], 2 * pi); }
};

/// The force that swings the pole up. A virtual spring and damper keep the cart near the middle.
double swing_up(const plant::Parameters<double>& p, const State& s) {
  const double energy = p.l * s.v[1] * s.v[1] / (2 * p.g) + std::cos(s.q[1]) - 1;  // E/(m g l)
  const double direction = s.v[1] * std::cos(s.q[1]) < 0 ? -1 : 1;
  const double wanted =
      direction * std::clamp(5 * energy, -0.7, 0.7) * p.g - 8 * s.q[0] - 2 * s.v[0];
  // Forward dynamics is affine in u: the acceleration of the cart is free + (pushed - free) u.
  const double free = plant::eigen::forward_dynamics(p, s.q, s.v, Force(0.0)).acceleration[0];
  const double pushed = plant::eigen::forward_dynamics(p, s.q, s.v, Force(1.0)).acceleration[0];
  return (wanted - free) / (pushed - free);
}

int main() {
  const plant::Parameters<double> p{};
  const Eigen::Vector2d zero(0, 0);
  const auto upright = plant::eigen::linearization(p, zero, zero, Force(0.0));
  const Eigen::RowVector4d K = lqr(upright.A, upright.B, Eigen::Matrix4d::Identity(), Force(1.0));
  std::printf("K = (%.4f, %.4f, %.4f, %.4f)\n", K[0], K[1], K[2], K[3]);
  const double h = 1e-3, angle = 0.01, place = 0.02;
  double settled = 0, force = 0, way = 0;
  State s;
  for (int sample = 1; sample <= 10000; ++sample) {
    const Eigen::Vector4d deviation(s.q[0], s.angle(), s.v[0], s.v[1]);
    const double asked = std::abs(s.angle()) < 0.3 ? -K * deviation : swing_up(p, s);
    const double u = std::clamp(asked, plant::input_limits[0].low, plant::input_limits[0].high);
    const auto next = plant::eigen::step(p, s.q, s.v, Force(u), h);
    s = {next.coordinates, next.rates};
    force = std::max(force, std::abs(u));
    way = std::max(way, std::abs(s.q[0]));
    if (!(std::abs(s.angle()) < angle && std::abs(s.q[0]) < place)) settled = sample * h;
  }
  const bool is_balanced = settled < 6 && way <= 2.5;
  std::printf("%s: last outside %.2f rad and %.2f m at %.1f s, at most %.1f N and %.2f m\n",
              is_balanced ? "balanced" : "failed", angle, place, settled, force, way);
  return is_balanced ? 0 : 1;
}
