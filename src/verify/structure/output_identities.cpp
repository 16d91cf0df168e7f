// The identities of an [[output]] and its derivatives.
#include "elgen/outputs.hpp"
#include "verify/structure/identities.hpp"

namespace elgen {
namespace {

using K = OutputKind;
using Values = std::vector<Real>;

// The twist of a frame: the angular velocity omega, and the velocity v of the origin. The twist is
// linear in the pose [R p] and linear in the rate of the pose, so the rate of the twist is a sum of
// two terms of the form:
//
//     in the world's axes    S = dR/dt R^T    v = dp/dt
//     in the frame's axes    S = R^T dR/dt    v = R^T dp/dt        omega = (S_32, S_13, S_21)

constexpr std::size_t axes = 3;
constexpr std::size_t columns = 4;  ///< of [R p]

const Real& pose_entry(const Values& pose, std::size_t row, std::size_t column) {
  return pose[columns * row + column];
}

/// The terms of a twist, three per component: S_32, S_13, S_21, then the components of dp/dt along
/// the columns of `along`.
Values twist_terms(const Values& pose, const Values& along, const Values& rate, bool in_world) {
  Values terms;
  for (std::size_t axis = 0; axis < axes; ++axis) {
    const std::size_t j = (axis + 1) % axes;
    const std::size_t i = (axis + 2) % axes;
    for (std::size_t k = 0; k < axes; ++k) {
      terms.push_back(in_world ? pose_entry(rate, i, k) * pose_entry(pose, j, k)
                               : pose_entry(pose, k, i) * pose_entry(rate, k, j));
    }
  }
  for (std::size_t axis = 0; axis < axes; ++axis) {
    for (std::size_t k = 0; k < axes; ++k) {
      terms.push_back(pose_entry(along, k, axis) * pose_entry(rate, k, axes));
    }
  }
  return terms;
}

/// A matrix whose first three columns are the axes of the twist: the frame's, or the world's.
Values twist_axes(const Values& pose, bool in_world) {
  if (!in_world) return pose;
  Values world(axes * columns);
  for (std::size_t i = 0; i < axes; ++i) world[columns * i + i] = Real(1);
  return world;
}

/// d^2 y/dt^2 along a motion with a = 0.
Values second_rate(ExactValues& at, const Arguments<Real>& motion, std::uint32_t user) {
  Values result = at.second_derivatives(K::user_value, motion, user);
  if (at.subject().model.rotations.empty()) return result;
  Arguments<Real> turning = at.zero_direction();
  turning.q = at.coasting_accelerations();
  const Values of_turning = at.directional_derivatives(K::user_value, turning, user);
  for (std::size_t i = 0; i < result.size(); ++i) result[i] = result[i] + of_turning[i];
  return result;
}

ResidualSums jacobian_balance(ExactValues& at, std::uint32_t user) {
  const UserOutput& output = at.subject().model.outputs[user];
  const Values& jacobian = at.entries(K::user_jacobian, user);
  const Values& y = at.entries(K::user_value, user);
  const std::size_t n = at.size();
  const std::size_t per_entry = output.frame ? axes : 1;
  BalanceTerms slopes{Values(jacobian.size() * per_entry), -1, per_entry};
  for (std::size_t j = 0; j < n; ++j) {
    Values column = at.directional_derivatives(K::user_value, unit_displacement(at, j), user);
    if (output.frame)
      column = twist_terms(y, twist_axes(y, output.is_in_world), column, output.is_in_world);
    for (std::size_t i = 0; i < column.size(); ++i) {
      slopes.values[(i / per_entry * n + j) * per_entry + i % per_entry] = column[i];
    }
  }
  return balance_of({{jacobian}, slopes});
}

ResidualSums output_bias_balance(ExactValues& at, std::uint32_t user) {
  const UserOutput& output = at.subject().model.outputs[user];
  Arguments<Real> motion = at.zero_direction();
  motion.q = at.coordinate_rates(at.arguments().v);
  motion.t = Real(1);
  const Values& bias = at.entries(K::user_bias, user);
  const Values acceleration = second_rate(at, motion, user);
  if (!output.frame) return balance_of({{bias}, {acceleration, -1}});
  const bool in_world = output.is_in_world;
  const Values& pose = at.entries(K::user_value, user);
  const Values rate = at.directional_derivatives(K::user_value, motion, user);
  // The rate of the axes; the world's axes do not move.
  const Values turning = in_world ? Values(rate.size()) : rate;
  return balance_of(
      {{bias},
       {twist_terms(pose, twist_axes(pose, in_world), acceleration, in_world), -1, axes},
       {twist_terms(rate, turning, rate, in_world), -1, axes}});
}

/// Appends the derivatives of y along the directions unit(0), ..., unit(count - 1), row-major.
template <class Unit>
void append_slopes(Values& slopes, ExactValues& at, std::uint32_t user, std::size_t count,
                   const Unit& unit) {
  const std::size_t rows = at.entries(K::user_value, user).size();
  const std::size_t first = slopes.size();
  slopes.resize(first + rows * count);
  for (std::size_t j = 0; j < count; ++j) {
    const Values column = at.directional_derivatives(K::user_value, unit(j), user);
    for (std::size_t i = 0; i < rows; ++i) slopes[first + i * count + j] = column[i];
  }
}

ResidualSums derivatives_balance(ExactValues& at, std::uint32_t user) {
  Values slopes;
  append_slopes(slopes, at, user, at.size(),
                [&](std::size_t j) { return unit_displacement(at, j); });
  const bool has_own_acceleration = at.subject().model.outputs[user].solves_motion;
  for (const auto leaf : {&Arguments<Real>::v, &Arguments<Real>::a, &Arguments<Real>::u}) {
    if (leaf == &Arguments<Real>::a && has_own_acceleration) continue;
    append_slopes(slopes, at, user, (at.arguments().*leaf).size(), [&](std::size_t j) {
      Arguments<Real> unit = at.zero_direction();
      (unit.*leaf)[j] = Real(1);
      return unit;
    });
  }
  return balance_of({{at.entries(K::user_derivatives, user)}, {slopes, -1}});
}

}  // namespace

const std::vector<OutputIdentity>& output_identities() {
  static const std::vector<OutputIdentity> table{
      {K::user_jacobian, "Jacobian by dual numbers", "J = dy/dq",
       "J = d(omega; dp/dt)/dv, [omega]x = dR/dt R^T", jacobian_balance},
      {K::user_bias, "output bias by dual numbers", "bias = d^2 y/dt^2 at a = 0",
       "bias = d(omega; dp/dt)/dt at a = 0", output_bias_balance},
      {K::user_derivatives, "derivatives by dual numbers", "dy/dq, dy/dv, dy/da, dy/du", "",
       derivatives_balance},
  };
  return table;
}

}  // namespace elgen
