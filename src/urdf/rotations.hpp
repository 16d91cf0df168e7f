// Constant rotations and axes. URDF files write a right angle as 1.57079632679. The cosine of this
// number is small instead of 0, and the equations get terms that should vanish. Therefore angles
// within 1e-5 rad of a multiple of a right angle are rounded to this multiple, and directions
// within 1e-5 rad of an axis to this axis.
#pragma once

#include <algorithm>
#include <optional>
#include <string>

#include "urdf/numbers.hpp"

namespace elgen::urdf {

/// round: rounds angles and directions as above. exact: keeps all numbers of the file.
enum class AngleRounding : unsigned char { round, exact };

struct Angle {
  std::string text = "0";                ///< "-pi/2", or the digits of the file
  std::optional<int> quarter_turns = 0;  ///< angle / (pi/2), if this is an integer
  bool is_rounded = false;               ///< `text` may differ from the file
  double change = 0.0;                   ///< by rounding, in rad

  [[nodiscard]] bool is_zero() const { return text == "0"; }
};

[[nodiscard]] Angle round_angle(const FileNumber& number, AngleRounding digits);

struct RollPitchYaw {
  std::array<Angle, 3> rpy = {};  ///< R = Rz(yaw) Ry(pitch) Rx(roll)

  [[nodiscard]] bool is_zero() const { return std::ranges::all_of(rpy, &Angle::is_zero); }
  [[nodiscard]] bool is_rounded() const { return std::ranges::any_of(rpy, &Angle::is_rounded); }
};

[[nodiscard]] RollPitchYaw round_rotation(const Vector& rpy, AngleRounding digits);

/// R I R^T (xx yy zz xy xz yz), with the digits of I; none if an angle is no multiple of pi/2.
[[nodiscard]] std::optional<std::array<FileNumber, 6>> rotate_inertia(
    const RollPitchYaw& rotation, const std::array<FileNumber, 6>& inertia);

/// A direction: an axis of the frame, or three numbers.
struct Axis {
  std::optional<std::size_t> index = {};  ///< 0 x, 1 y, 2 z
  bool is_reversed = false;               ///< along -x, -y, -z
  bool is_rounded = false;
  double change = 0.0;  ///< by rounding, in rad
};

[[nodiscard]] Axis snap_axis(const Vector& direction, AngleRounding digits);

}  // namespace elgen::urdf
