// Quarter turns are signed permutations of the axes, so rotated numbers keep their digits.
#include "urdf/rotations.hpp"

#include <cln/float.h>
#include <cln/rational.h>
#include <cln/real.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace elgen::urdf {

namespace {

constexpr double tolerance = 1e-5;  // rad
constexpr double right_angle = 1.5707963267948966;
constexpr unsigned exact_digits = 40;

/// Distance of a number from a multiple of a right angle, in rad.
double distance(const cln::cl_RA& value, int right_angles) {
  const cln::float_format_t precision = cln::float_format(exact_digits);
  const cln::cl_R exact = cln::cl_float(value, precision);
  return std::abs(clamped_double(cln::rational(exact - right_angles * cln::pi(precision) / 2)));
}

std::string multiple_of_right_angle(int count) {
  const std::string sign = count < 0 ? "-" : "";
  const int size = std::abs(count);
  const int times = size % 2 == 0 ? size / 2 : size;
  return sign + (times == 1 ? "" : fmt::format("{}*", times)) + (size % 2 == 0 ? "pi" : "pi/2");
}

/// Row i of a signed permutation has `sign` in column `column`: (R x)[i] = sign * x[column].
struct SignedAxis {
  std::size_t column = 0;
  int sign = 1;
};
using SignedPermutation = std::array<SignedAxis, 3>;

/// The rotation `before`, followed by a quarter turn about an axis.
SignedPermutation apply_quarter_turn(const SignedPermutation& before, std::size_t axis) {
  const std::size_t next = (axis + 1) % 3;
  const std::size_t last = (axis + 2) % 3;
  SignedPermutation after = before;
  after[next] = {before[last].column, -before[last].sign};
  after[last] = before[next];
  return after;
}

std::size_t inertia_index(std::size_t row, std::size_t column) {
  return row == column ? row : row + column + 2;
}

}  // namespace

Angle round_angle(const FileNumber& number, AngleRounding digits) {
  if (number.is_zero()) return {};
  if (digits == AngleRounding::exact) return {number.text, std::nullopt};
  const double angle = clamped_double(number.value);
  constexpr double largest = 1e6;  // larger angles are never meant as multiples of a right angle
  if (std::abs(angle) > largest) return {number.text, std::nullopt};
  const double count = std::round(angle / right_angle);
  if (std::abs(angle - count * right_angle) > tolerance) return {number.text, std::nullopt};
  const int turns = static_cast<int>(count);
  return {turns % 4 == 0 ? "0" : multiple_of_right_angle(turns), turns, true,
          distance(number.value, turns)};
}

RollPitchYaw round_rotation(const Vector& rpy, AngleRounding digits) {
  return {{round_angle(rpy[0], digits), round_angle(rpy[1], digits), round_angle(rpy[2], digits)}};
}

std::optional<std::array<FileNumber, 6>> rotate_inertia(const RollPitchYaw& rotation,
                                                        const std::array<FileNumber, 6>& inertia) {
  SignedPermutation permutation{{{0, 1}, {1, 1}, {2, 1}}};
  for (std::size_t axis = 0; axis < 3; ++axis) {  // about x, y, z of the outer frame, in this order
    const std::optional<int>& count = rotation.rpy[axis].quarter_turns;
    if (!count) return std::nullopt;
    for (int turn = 0; turn < (*count % 4 + 4) % 4; ++turn)
      permutation = apply_quarter_turn(permutation, axis);
  }
  std::array<FileNumber, 6> result;
  for (std::size_t row = 0; row < 3; ++row) {
    for (std::size_t column = row; column < 3; ++column) {
      const auto [first, first_sign] = permutation[row];
      const auto [second, second_sign] = permutation[column];
      const FileNumber& entry = inertia[inertia_index(first, second)];
      result[inertia_index(row, column)] = first_sign == second_sign ? entry : negate_number(entry);
    }
  }
  return result;
}

Axis snap_axis(const Vector& direction, AngleRounding digits) {
  const auto shorter = [](const FileNumber& left, const FileNumber& right) {
    return cln::abs(left.value) < cln::abs(right.value);
  };
  const auto* longest = std::ranges::max_element(direction, shorter);
  const auto along = static_cast<std::size_t>(longest - direction.begin());
  const FileNumber& second = direction[(along + 1) % 3];
  const FileNumber& third = direction[(along + 2) % 3];
  const double sine = std::hypot(clamped_double(second.value / longest->value),
                                 clamped_double(third.value / longest->value));
  const bool is_exact = second.is_zero() && third.is_zero();
  if (sine > tolerance || (digits == AngleRounding::exact && !is_exact)) return {};
  return {along, cln::minusp(longest->value), !is_exact, std::asin(sine)};
}

}  // namespace elgen::urdf
