// The twist is a form, linear in a pose and linear in its rate, so that its rate is that form
// twice.
#include "verify/structure/twist.hpp"

namespace elgen {
namespace {

using Values = std::vector<Real>;

constexpr std::size_t axes = 3;
constexpr std::size_t columns = 4;  ///< of [R p]

const Real& entry(const Values& pose, std::size_t row, std::size_t column) {
  return pose[columns * row + column];
}

/// S_32, S_13, S_21
void subtract_spin(const TwistPlace& place, const Values& pose, const Values& rate) {
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
void subtract_velocity(const TwistPlace& place, const Values& along, const Values& rate) {
  for (std::size_t axis = 0; axis < axes; ++axis) {
    for (std::size_t k = 0; k < axes; ++k) {
      const Real term = entry(along, k, axis) * entry(rate, k, axes);
      place.balance.add(place.first + (axes + axis) * place.stride, -term);
    }
  }
}

/// The world's own axes.
Values identity() {
  Values pose(axes * columns);
  for (std::size_t i = 0; i < axes; ++i) pose[columns * i + i] = Real(1);
  return pose;
}

}  // namespace

void subtract_twist(const TwistPlace& place, const PoseMotion& motion) {
  subtract_spin(place, motion.pose, motion.rate);
  subtract_velocity(place, place.in_world ? identity() : motion.pose, motion.rate);
}

void subtract_twist_rate(const TwistPlace& place, const PoseMotion& motion) {
  subtract_spin(place, motion.pose, motion.second_rate);
  subtract_spin(place, motion.rate, motion.rate);
  subtract_velocity(place, place.in_world ? identity() : motion.pose, motion.second_rate);
  if (!place.in_world) subtract_velocity(place, motion.rate, motion.rate);
}

}  // namespace elgen
