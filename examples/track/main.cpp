// SPDX-License-Identifier: 0BSD
// Moves the tip of an arm along a circle by computed torque control at 1 kHz (Siciliano, Sciavicco,
// Villani, Oriolo, Robotics, 2009, section 8.5.2). With an exact model the torques
//     tau = M(q) (a_r + kd (v_r - v) + kp (q_r - q)) + bias(q, v)
// give the error e = q_r - q the dynamics e'' + kd e' + kp e = 0.
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <stdexcept>

#include "two_link_arm_track/two_link_arm_track_eigen.hpp"

namespace arm = two_link_arm_track;
using Eigen::Vector2d;

struct Motion {
  Vector2d x, v, a;
};

/// Joint angles, rates and accelerations for a motion of the tip, with the elbow below.
Motion inverse_kinematics(const arm::Parameters<double>& p, const Motion& tip) {
  const double l2 = 2 * p.c2;
  const double cosine = (tip.x.squaredNorm() - p.l1 * p.l1 - l2 * l2) / (2 * p.l1 * l2);
  if (std::abs(cosine) > 1) throw std::domain_error("the arm does not reach the circle");
  Motion joints;
  joints.x[1] = std::acos(cosine);
  joints.x[0] =
      std::atan2(tip.x[1], tip.x[0]) - std::atan2(l2 * std::sin(joints.x[1]), p.l1 + l2 * cosine);
  const Eigen::Matrix2d inverse = arm::eigen::tip_jacobian(p, joints.x).inverse();
  joints.v = inverse * tip.v;
  joints.a = inverse * (tip.a - arm::eigen::tip_bias(p, joints.x, joints.v));
  return joints;
}

/// The desired motion of the tip: a circle of radius 0.2 m about (1.02, 0.2) m, once in two
/// seconds.
Motion reference(const arm::Parameters<double>& p, double t) {
  const double w = 3.141592653589793, radius = 0.2;
  const Vector2d out(radius * std::cos(w * t), radius * std::sin(w * t));
  return inverse_kinematics(
      p, {Vector2d(1.02, 0.2) + out, w * Vector2d(-out[1], out[0]), -w * w * out});
}

/// The largest joint error during three rounds. The arm `real` starts on the circle, and the
/// controller assumes the parameters `model`.
double largest_error(const arm::Parameters<double>& model, const arm::Parameters<double>& real) {
  const double h = 1e-3, kp = 400, kd = 40;
  double largest = 0;
  Motion wanted = reference(model, 0);
  Vector2d q = wanted.x, v = wanted.v;
  for (int sample = 1; sample <= 6000; ++sample) {
    const Vector2d a = wanted.a + kd * (wanted.v - v) + kp * (wanted.x - q);
    const Vector2d torque = arm::eigen::inverse_dynamics(model, q, v, a);
    const auto next = arm::eigen::step(real, q, v, torque, h);
    q = next.coordinates;
    v = next.rates;
    wanted = reference(model, sample * h);
    largest = std::max((wanted.x - q).cwiseAbs().maxCoeff(), largest);  // max(NaN, x) is NaN
  }
  return largest;
}

int main() {
  const arm::Parameters<double> model{};
  arm::Parameters<double> heavier{};
  heavier.m2 *= 1.2;
  const double right = largest_error(model, model), wrong = largest_error(model, heavier);
  std::printf("off by at most %.1e rad, and by %.1e rad with 20 %% more on link 2\n", right, wrong);
  return right <= 1e-4 && wrong <= 1e-2 ? 0 : 1;
}
