// The twist of a pose that turns about each axis of the world, against its closed form.
#include "verify/structure/twist.hpp"

#include <catch2/catch.hpp>

#include "support/real.hpp"

using namespace elgen;
using test::real;

namespace {

using Values = std::vector<Real>;

constexpr double tolerance = 1e-60;  ///< of 64 digits

const Real c = real("3/5");
const Real s = real("4/5");
const Real w = real("7/3");     ///< of the angle
const Real alpha = real("-2");  ///< of w
const Values velocity{real("5"), real("-3"), real("1/2")};
const Values acceleration{real("2"), real("11"), real("-1/7")};

/// [R p] with R = [[x, -y], [y, x]] in the plane across the axis and z along it.
Values pose(std::size_t axis, const Values& xyz, const Values& p) {
  Values result(12);
  const std::size_t i = (axis + 1) % 3;
  const std::size_t j = (axis + 2) % 3;
  result[4 * i + i] = result[4 * j + j] = xyz[0];
  result[4 * j + i] = xyz[1];
  result[4 * i + j] = -xyz[1];
  result[4 * axis + axis] = xyz[2];
  for (std::size_t k = 0; k < 3; ++k) result[4 * k + 3] = p[k];
  return result;
}

PoseMotion motion(std::size_t axis) {
  return {pose(axis, {c, s, Real(1)}, {Real(1), Real(2), Real(3)}),
          pose(axis, {-(w * s), w * c, Real()}, velocity),
          pose(axis, {-(alpha * s) - w * w * c, alpha * c - w * w * s, Real()}, acceleration)};
}

/// R^T x of the pose, which R' of another replaces for its rate.
Values turned(const Values& pose, const Values& x) {
  Values result(3);
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t k = 0; k < 3; ++k) result[i] = result[i] + pose[4 * k + i] * x[k];
  }
  return result;
}

Values twist(std::size_t axis, const Real& spin, const Values& linear) {
  Values result(3);
  result[axis] = spin;
  result.insert(result.end(), linear.begin(), linear.end());
  return result;
}

Values sum(Values x, const Values& y) {
  for (std::size_t i = 0; i < x.size(); ++i) x[i] = x[i] + y[i];
  return x;
}

double figure(const Values& expected, const PoseMotion& of, bool in_world,
              void (*subtract)(const TwistPlace&, const PoseMotion&)) {
  Balance balance(12);
  for (std::size_t i = 0; i < 6; ++i) balance.add(1 + 2 * i, expected[i]);
  subtract({balance, 1, 2, in_world}, of);
  return balance.figure(Real()).value();
}

}  // namespace

TEST_CASE("the twist of a pose, in both axes") {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const PoseMotion of = motion(axis);
    CHECK(figure(twist(axis, w, velocity), of, true, subtract_twist) < tolerance);
    CHECK(figure(twist(axis, w, turned(of.pose, velocity)), of, false, subtract_twist) < tolerance);
    // Another sign of the spin, and axes mistaken for each other.
    CHECK(figure(twist(axis, -w, velocity), of, true, subtract_twist) > 0.1);
    CHECK(figure(twist(axis, w, velocity), of, false, subtract_twist) > 0.1);
  }
}

TEST_CASE("the rate of a twist, in both axes") {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const PoseMotion of = motion(axis);
    CHECK(figure(twist(axis, alpha, acceleration), of, true, subtract_twist_rate) < tolerance);
    const Values turning = turned(of.rate, velocity);
    const Values body = sum(turned(of.pose, acceleration), turning);
    CHECK(figure(twist(axis, alpha, body), of, false, subtract_twist_rate) < tolerance);
    CHECK(figure(twist(axis, alpha, turned(of.pose, acceleration)), of, false,
                 subtract_twist_rate) > 0.1);
  }
}
