// Constant rotations and axes, and the largest change of a pose when an angle is rounded to a right
// angle.
#include "urdf/rotations.hpp"

#include <catch2/catch.hpp>

#include "urdf/urdf_testing.hpp"

namespace elgen::test {

namespace {

urdf::FileNumber decimal(const std::string& text) {
  const SourcePointer source = make_source("r.urdf", text);
  return *urdf::read_decimal({source.get(), 0, static_cast<std::uint32_t>(text.size())}, {});
}

urdf::Vector vector(const std::string& x, const std::string& y, const std::string& z) {
  return {decimal(x), decimal(y), decimal(z)};
}

std::string angle(const std::string& text) {
  return urdf::round_angle(decimal(text), urdf::AngleRounding::round).text;
}

urdf::RollPitchYaw rotation(const urdf::Vector& rpy) {
  return urdf::round_rotation(rpy, urdf::AngleRounding::round);
}

/// The direction of an axis: "x", "-z", "y rounded" or "oblique".
std::string axis(const std::string& x, const std::string& y, const std::string& z) {
  const urdf::Axis result = urdf::snap_axis(vector(x, y, z), urdf::AngleRounding::round);
  if (!result.index) return "oblique";
  return (result.is_reversed ? "-" : "") + std::string(1, "xyz"[*result.index]) +
         (result.is_rounded ? " rounded" : "");
}

/// The entries of the rotated inertia, one after another. Without rotation they are 123456.
std::string rotated_digits(const std::string& roll, const std::string& pitch,
                           const std::string& yaw) {
  const std::array<urdf::FileNumber, 6> inertia{decimal("1"), decimal("2"), decimal("3"),
                                                decimal("4"), decimal("5"), decimal("6")};
  const auto result = urdf::rotate_inertia(rotation(vector(roll, pitch, yaw)), inertia);
  if (!result) return "oblique";
  std::string text;
  for (const urdf::FileNumber& entry : *result) text += entry.text;
  return text;
}

/// An arm with its origin 2 m from the base, and its centre of mass 0.1 m from the origin.
std::string model_with_angles(const std::string& rpy, const std::string& axis = "0 0 1") {
  return arm_on("revolute",
                "<origin xyz=\"0 2 0\" rpy=\"" + rpy + "\"/><axis xyz=\"" + axis + "\"/>");
}

}  // namespace

TEST_CASE("an angle near a multiple of a right angle is rounded to it") {
  CHECK(angle("1.57079632679") == "pi/2");
  CHECK(angle("-1.5708") == "-pi/2");
  CHECK(angle("3.14159") == "pi");
  CHECK(angle("-3.1415926535") == "-pi");
  CHECK(angle("4.71238898") == "3*pi/2");
  CHECK(angle("6.28318530718") == "0");
  CHECK(angle("1e-6") == "0");
  CHECK(angle("0") == "0");
}

TEST_CASE("other angles keep their digits") {
  CHECK(angle("1.57") == "1.57");
  CHECK(angle("0.785398163397") == "0.785398163397");
  CHECK(angle("2e-5") == "2e-5");
  CHECK(angle("1e300") == "1e300");
}

TEST_CASE("an axis near x, y or z is rounded to it, whatever its length") {
  CHECK(axis("0", "0", "1") == "z");
  CHECK(axis("0", "-1", "0") == "-y");
  CHECK(axis("1e-200", "0", "0") == "x");
  CHECK(axis("1e300", "0", "1e-300") == "x rounded");
  CHECK(axis("0", "1", "6.1e-17") == "y rounded");
  CHECK(axis("0.6", "0", "0.8") == "oblique");
  CHECK(axis("1e-4", "0", "1") == "oblique");
}

TEST_CASE("quarter turns permute the digits of an inertia") {
  CHECK(rotated_digits("0", "0", "0") == "123456");
  CHECK(rotated_digits("1.5707963", "0", "0") == "132-54-6");
  CHECK(rotated_digits("0", "1.5707963", "0") == "3216-5-4");
  CHECK(rotated_digits("0", "0", "1.5707963") == "213-4-65");
  CHECK(rotated_digits("0", "0", "3.1415927") == "1234-5-6");
  CHECK(rotated_digits("1.5707963", "0", "1.5707963") == "312564");
  CHECK(rotated_digits("-1.5707963", "0", "0") == rotated_digits("4.712389", "0", "0"));
  CHECK(rotated_digits("0", "0.3", "0") == "oblique");
}

TEST_CASE("a rotation states whether it is the identity, and whether its digits were changed") {
  CHECK(rotation(vector("0", "0", "0")).is_zero());
  CHECK_FALSE(rotation(vector("0", "0.1", "0")).is_zero());
  CHECK_FALSE(rotation(vector("0", "0.1", "0")).is_rounded());
  CHECK(rotation(vector("0", "0", "1.5708")).is_rounded());
}

TEST_CASE("the change of an angle is known more precisely than the rounding of double") {
  const auto change = [](const std::string& text) {
    return urdf::round_angle(decimal(text), urdf::AngleRounding::round).change;
  };
  CHECK(change("1.5707963267948966") == Approx(1.9231e-17).epsilon(1e-4));
  CHECK(change("-3.14159") == Approx(2.65359e-6).epsilon(1e-5));
  CHECK(change("0") == 0.0);
  CHECK(urdf::snap_axis(vector("0", "1", "1e-6"), urdf::AngleRounding::round).change ==
        Approx(1e-6));
}

TEST_CASE("exact angles and axes keep their digits") {
  const urdf::AngleRounding kept = urdf::AngleRounding::exact;
  CHECK(urdf::round_angle(decimal("1.57079632679"), kept).text == "1.57079632679");
  CHECK_FALSE(urdf::round_angle(decimal("1e-9"), kept).is_rounded);
  CHECK(urdf::round_angle(decimal("0"), kept).quarter_turns == 0);
  CHECK_FALSE(urdf::snap_axis(vector("0", "1", "6.1e-17"), kept).index);
  CHECK(urdf::snap_axis(vector("0", "-2", "0"), kept).index == 1U);
}

TEST_CASE("one note states the number of angles and the largest change of a pose") {
  CHECK(import_messages(model_with_angles("1.570796 0 0")) ==
        "E819 1:2 1 angle is rounded to right angles: no pose changes by more than 3.3e-07 rad and "
        "3.3e-08 m | `--exact-angles` keeps their digits\n");
  CHECK(import_messages(model_with_angles("1.570796 0 3.141593", "0 1e-6 1")) ==
        "E819 1:2 3 angles are rounded to right angles: no pose changes by more than 1.7e-06 rad "
        "and 1.7e-07 m | `--exact-angles` keeps their digits\n");
}

TEST_CASE("if nothing is rounded, there is no note") {
  CHECK(import_messages(model_with_angles("0 0.3 0")).empty());
  ImportOptions options;
  options.exact_angles = true;
  CHECK(import_messages(model_with_angles("1.570796 0 0"), options).empty());
  CHECK(after(imported(model_with_angles("1.570796 0 0"), options), "rotate    = ") ==
        "[[\"x\", \"1.570796\"], [\"z\", \"j\"]]");
}

}  // namespace elgen::test
