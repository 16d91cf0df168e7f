// SPDX-License-Identifier: 0BSD
// An extended Kalman filter estimates the state of an arm from an encoder at the first joint and a
// gyro on the second link:
//     x = Phi(x, u),              P = A P A^T + Q           step, step_derivatives
//     K = P H^T (H P H^T + R)^-1, x += K (z - y(x))         sensors, sensors_derivatives
// The second angle has no sensor, but gravity and inertia make it observable.
#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <random>

#include "two_link_arm_estimate/two_link_arm_estimate_eigen.hpp"

namespace arm = two_link_arm_estimate;
using Eigen::Matrix4d;
using Eigen::Vector2d;
using Eigen::Vector4d;

const arm::Parameters<double> parameters{};

Vector4d moved(const Vector4d& x, const Vector2d& u, double h) {
  const auto next = arm::eigen::step(parameters, x.head<2>(), x.tail<2>(), u, h);
  Vector4d after;
  after << next.coordinates, next.rates;
  return after;
}

int main() {
  const double h = 2e-3;
  const Vector2d noise(1e-3, 1e-2);  // standard deviations in rad and rad/s
  const Eigen::Matrix2d r = noise.cwiseAbs2().asDiagonal();
  const Matrix4d q = Vector4d(1e-12, 1e-12, 1e-9, 1e-9).asDiagonal();
  std::mt19937 engine;  // default seed: the same numbers on every machine
  const auto unit = [&engine] { return std::sqrt(3.0) * (engine() / 2147483648.0 - 1); };

  Vector4d truth(-1.2, 0.7, 0, 0);
  Vector4d estimate(-1.2, 0, 0, 0);
  Matrix4d p = Vector4d(1e-2, 1, 1e-2, 1e-2).asDiagonal();
  const double at_first = std::abs(estimate[1] - truth[1]);
  double at_last = 0;
  for (int sample = 0; sample < 5000; ++sample) {
    const Vector2d torque(4 * std::sin(3 * h * sample), 1.5 * std::cos(5 * h * sample));
    truth = moved(truth, torque, h);
    const auto change =
        arm::eigen::step_derivatives(parameters, estimate.head<2>(), estimate.tail<2>(), torque, h);
    estimate = moved(estimate, torque, h);
    p = change.A * p * change.A.transpose() + q;

    const Vector2d errors(noise[0] * unit(), noise[1] * unit());
    const Vector2d measured =
        arm::eigen::sensors(parameters, truth.head<2>(), truth.tail<2>()) + errors;
    const auto slopes =
        arm::eigen::sensors_derivatives(parameters, estimate.head<2>(), estimate.tail<2>());
    Eigen::Matrix<double, 2, 4> slope;
    slope << slopes.by_position, slopes.by_velocity;
    const Eigen::Matrix<double, 4, 2> gain =
        p * slope.transpose() * (slope * p * slope.transpose() + r).inverse();
    estimate +=
        gain * (measured - arm::eigen::sensors(parameters, estimate.head<2>(), estimate.tail<2>()));
    p = (Matrix4d::Identity() - gain * slope) * p;
    if (sample >= 4000) at_last = std::max(std::abs(estimate[1] - truth[1]), at_last);
  }
  std::printf(
      "the angle without a sensor: off by %.1f rad at first, by at most %.1e rad in the end\n",
      at_first, at_last);
  return at_last <= 5e-3 ? 0 : 1;
}
