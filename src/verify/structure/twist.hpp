// Twist: what the pose [R p] of a frame's output says of its twist (angular velocity; velocity of
// the origin).
//
//     in the world's axes    S = dR/dt R^T    v = dp/dt
//     in the frame's         S = R^T dR/dt    v = R^T dp/dt        omega = (S_32, S_13, S_21)
#pragma once

#include <vector>

#include "verify/structure/balance.hpp"

namespace elgen {

/// Where the six components of a twist stand in a balance: at first, first + stride, …
struct TwistPlace {
  Balance& balance;
  std::size_t first = 0;
  std::size_t stride = 1;
  bool in_world = true;
};

/// A pose, 3 x 4 row by row, with its rate and its second rate.
struct PoseMotion {
  std::vector<Real> pose = {};
  std::vector<Real> rate = {};
  std::vector<Real> second_rate = {};
};

/// balance -= twist
void subtract_twist(const TwistPlace& place, const PoseMotion& motion);

/// balance -= d twist/dt
void subtract_twist_rate(const TwistPlace& place, const PoseMotion& motion);

}  // namespace elgen
