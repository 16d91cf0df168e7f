// SPDX-License-Identifier: 0BSD
// An extended Kalman filter for the cart and its pole: the Jacobian of a step of Runge and Kutta's
// method is that of Eigen's automatic differentiation.
//
//     elgen generate -o generated models/scenes/cart_pole_prediction.scene.toml
//     g++ -std=c++17 -O2 -Igenerated -isystem /usr/include/eigen3 ekf.cpp -o ekf
#include <Eigen/Dense>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <unsupported/Eigen/AutoDiff>

#include "cart_pole_prediction/cart_pole_prediction.hpp"

namespace plant = cart_pole_prediction;

using State = Eigen::Vector4d;  // x, theta, dx/dt, dtheta/dt
using Matrix = Eigen::Matrix4d;

constexpr double h = 0.01;

template <class Scalar>
Eigen::Matrix<Scalar, 4, 1> stepped(const Eigen::Matrix<Scalar, 4, 1>& x, double u) {
  const plant::Parameters<Scalar> p{};
  const auto after = plant::step<Scalar>(p, {x[0], x[1]}, {x[2], x[3]}, {Scalar(u)}, Scalar(h));
  return {after.coordinates[0], after.coordinates[1], after.rates[0], after.rates[1]};
}

/// The state after a step, and F = d(after)/d(before).
State predicted(const State& before, double u, Matrix& F) {
  using Dual = Eigen::AutoDiffScalar<Eigen::Vector4d>;
  Eigen::Matrix<Dual, 4, 1> x;
  for (int i = 0; i < 4; ++i) x[i] = Dual(before[i], 4, i);
  const auto after = stepped<Dual>(x, u);
  State state;
  for (int i = 0; i < 4; ++i) {
    state[i] = after[i].value();
    F.row(i) = after[i].derivatives();
  }
  return state;
}

/// Noise between -1 and 1, the same on every machine.
double noise() {
  static std::uint32_t number = 1;
  number = 1664525U * number + 1013904223U;
  return static_cast<double>(number) / 2147483648.0 - 1.0;
}

int main() {
  constexpr double off_x = 0.01;      // m, what the sensors are off by at most
  constexpr double off_theta = 0.02;  // rad
  Eigen::Matrix<double, 2, 4> H = Eigen::Matrix<double, 2, 4>::Zero();  // x and theta are measured
  H(0, 0) = H(1, 1) = 1;
  const Eigen::Matrix2d R =
      Eigen::Vector2d(off_x * off_x / 3, off_theta * off_theta / 3).asDiagonal();
  const Matrix Q = 1e-8 * Matrix::Identity();

  State truth(0, 3.0, 0, 0);
  State estimate(0, 2.8, 0, 0);
  Matrix P = 0.1 * Matrix::Identity();
  double from_estimate = 0;
  double from_differences = 0;
  double last = truth[1];
  constexpr int steps = 500;
  for (int i = 0; i < steps; ++i) {
    const double u = 5 * std::sin(3 * h * i);
    truth = stepped<double>(truth, u);
    Matrix F;
    estimate = predicted(estimate, u, F);
    P = F * P * F.transpose() + Q;
    Eigen::Vector2d measured(truth[0], truth[1]);
    measured[0] += off_x * noise();
    measured[1] += off_theta * noise();
    const Eigen::Matrix<double, 4, 2> gain =
        P * H.transpose() * (H * P * H.transpose() + R).inverse();
    estimate += gain * (measured - H * estimate);
    P = (Matrix::Identity() - gain * H) * P;
    from_estimate += std::pow(estimate[3] - truth[3], 2) / steps;
    from_differences += std::pow((measured[1] - last) / h - truth[3], 2) / steps;
    last = measured[1];
  }
  std::printf("dtheta/dt is off by %.3f rad/s, by %.1f rad/s from differences of measurements\n",
              std::sqrt(from_estimate), std::sqrt(from_differences));
}
