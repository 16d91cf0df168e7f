// Constant rotations and axes. URDF writes a right angle as 1.57079632679, which is none: sine and
// cosine of it are small numbers instead of 0, and the structure of the equations is lost. So what
// is within 1e-5 rad of a right angle, or of an axis, is taken for it.
#pragma once

#include <algorithm>
#include <optional>
#include <string>

#include "urdf/numbers.hpp"

namespace elgen::urdf {

/// Whether what is near a right angle is taken for it.
enum class AngleDigits : unsigned char { rounded, kept };

struct Angle {
  std::string text = "0";                ///< "-pi/2", or the digits of the file
  std::optional<int> quarter_turns = 0;  ///< where it is a multiple of a right angle
  bool is_rounded = false;               ///< the file has other digits
  double change = 0.0;                   ///< by that, rad

  [[nodiscard]] bool is_zero() const { return text == "0"; }
};

[[nodiscard]] Angle angle_of(const FileNumber& number, AngleDigits digits);

struct RollPitchYaw {
  std::array<Angle, 3> rpy = {};  ///< R = Rz(yaw) Ry(pitch) Rx(roll)

  [[nodiscard]] bool is_zero() const { return std::ranges::all_of(rpy, &Angle::is_zero); }
  [[nodiscard]] bool is_rounded() const { return std::ranges::any_of(rpy, &Angle::is_rounded); }
};

[[nodiscard]] RollPitchYaw rotation_of(const Vector& rpy, AngleDigits digits);

/// R I R^T (xx yy zz xy xz yz), digit by digit; not a value unless all angles are quarter turns.
[[nodiscard]] std::optional<std::array<FileNumber, 6>> rotated(
    const RollPitchYaw& rotation, const std::array<FileNumber, 6>& inertia);

/// A direction: an axis of the frame, or three numbers.
struct Axis {
  std::optional<std::size_t> along = {};  ///< 0 x, 1 y, 2 z
  bool is_reversed = false;               ///< along -x, -y, -z
  bool is_rounded = false;
  double change = 0.0;  ///< by that, rad
};

[[nodiscard]] Axis axis_of(const Vector& direction, AngleDigits digits);

}  // namespace elgen::urdf
