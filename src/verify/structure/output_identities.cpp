// The identities of an [[output]] and its derivatives.
#include "elgen/outputs.hpp"
#include "verify/structure/identities.hpp"

namespace elgen {
namespace {

using K = OutputKind;

// The pose [R p] of a frame's output gives its twist (angular velocity; velocity of the origin) as
// a form linear in the pose and in its rate, so that its rate is that form twice:
//
//     in the world's axes    S = dR/dt R^T    v = dp/dt
//     in the frame's         S = R^T dR/dt    v = R^T dp/dt        omega = (S_32, S_13, S_21)

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

constexpr std::size_t axes = 3;
constexpr std::size_t columns = 4;  ///< of [R p]

const Real& entry(const std::vector<Real>& pose, std::size_t row, std::size_t column) {
  return pose[columns * row + column];
}

/// S_32, S_13, S_21
void subtract_spin(const TwistPlace& place, const std::vector<Real>& pose,
                   const std::vector<Real>& rate) {
  for (std::size_t axis = 0; axis < axes; ++axis) {
    const std::size_t j = (axis + 1) % axes;
    const std::size_t i = (axis + 2) % axes;
    for (std::size_t k = 0; k < axes; ++k) {
      const Real term = place.in_world ? entry(rate, i, k) * entry(pose, j, k)
                                       : entry(pose, k, i) * entry(rate, k, j);
      place.balance.add(place.first + axis * place.stride, -term);
    }
  }
}

/// Components of dp/dt along the columns of `along`.
void subtract_velocity(const TwistPlace& place, const std::vector<Real>& along,
                       const std::vector<Real>& rate) {
  for (std::size_t axis = 0; axis < axes; ++axis) {
    for (std::size_t k = 0; k < axes; ++k) {
      const Real term = entry(along, k, axis) * entry(rate, k, axes);
      place.balance.add(place.first + (axes + axis) * place.stride, -term);
    }
  }
}

/// The world's own axes.
std::vector<Real> identity() {
  std::vector<Real> pose(axes * columns);
  for (std::size_t i = 0; i < axes; ++i) pose[columns * i + i] = Real(1);
  return pose;
}

/// balance -= twist
void subtract_twist(const TwistPlace& place, const PoseMotion& motion) {
  subtract_spin(place, motion.pose, motion.rate);
  subtract_velocity(place, place.in_world ? identity() : motion.pose, motion.rate);
}

/// balance -= d twist/dt
void subtract_twist_rate(const TwistPlace& place, const PoseMotion& motion) {
  subtract_spin(place, motion.pose, motion.second_rate);
  subtract_spin(place, motion.rate, motion.rate);
  subtract_velocity(place, place.in_world ? identity() : motion.pose, motion.second_rate);
  if (!place.in_world) subtract_velocity(place, motion.rate, motion.rate);
}

/// d^2 y/dt^2 at a = 0 along a motion.
std::vector<Real> second_rate(ExactValues& at, const Arguments<Real>& motion, std::uint32_t user) {
  std::vector<Real> result = at.curvatures(K::user_value, motion, user);
  if (at.subject().model.rotations.empty()) return result;
  Arguments<Real> turning = at.at_rest();
  turning.q = at.coasting_accelerations();
  const std::vector<Real> of_turning = at.slopes(K::user_value, turning, user);
  for (std::size_t i = 0; i < result.size(); ++i) result[i] = result[i] + of_turning[i];
  return result;
}

Balance jacobian_balance(ExactValues& at, std::uint32_t user) {
  const UserOutput& output = at.subject().model.outputs[user];
  const std::vector<Real>& jacobian = at.value(K::user_jacobian, user);
  const std::size_t n = at.size();
  Balance balance = balance_of({Terms{jacobian}});
  for (std::size_t j = 0; j < n; ++j) {
    const std::vector<Real> column = at.slopes(K::user_value, unit_position(at, j), user);
    if (output.frame) {
      subtract_twist({balance, j, n, output.in_world}, {at.value(K::user_value, user), column});
      continue;
    }
    for (std::size_t i = 0; i < column.size(); ++i) balance.add(i * n + j, -column[i]);
  }
  return balance;
}

Balance output_bias_balance(ExactValues& at, std::uint32_t user) {
  const UserOutput& output = at.subject().model.outputs[user];
  Arguments<Real> motion = at.at_rest();
  motion.q = at.coordinate_rates(at.arguments().v);
  motion.t = Real(1);
  const std::vector<Real>& bias = at.value(K::user_bias, user);
  const std::vector<Real> acceleration = second_rate(at, motion, user);
  if (!output.frame) return balance_of({{bias}, {acceleration, -1}});
  Balance balance = balance_of({Terms{bias}});
  const PoseMotion pose{at.value(K::user_value, user), at.slopes(K::user_value, motion, user),
                        acceleration};
  subtract_twist_rate({balance, 0, 1, output.in_world}, pose);
  return balance;
}

}  // namespace

const std::vector<OutputIdentity>& output_identities() {
  static const std::vector<OutputIdentity> table{
      {K::user_jacobian, "Jacobian by dual numbers", "J = dy/dq",
       "J = d(omega; dp/dt)/dv, [omega]x = dR/dt R^T", jacobian_balance},
      {K::user_bias, "output bias by dual numbers", "bias = d^2 y/dt^2 at a = 0",
       "bias = d(omega; dp/dt)/dt at a = 0", output_bias_balance},
  };
  return table;
}

}  // namespace elgen
