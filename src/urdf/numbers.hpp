// Numbers of a URDF: their digits, as TOML writes them, and their exact values; never a double.
#pragma once

#include <cln/rational.h>

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "elgen/diagnostic.hpp"
#include "elgen/limits.hpp"

namespace elgen::urdf {

struct FileNumber {
  std::string text = "0";  ///< the digits of the file: `+.50` is `0.50`, every zero is `0`
  cln::cl_RA value = 0;
  Span span = {};

  [[nodiscard]] bool is_zero() const { return text == "0"; }
};

/// Hint on a file that xacro has not expanded yet.
inline constexpr std::string_view xacro_remedy =
    "expand the file first: `xacro FILE > robot.urdf`, in ROS 2 `ros2 run xacro xacro FILE > "
    "robot.urdf`";

/// xacro_remedy if the text of `span` has a macro of xacro, "$(arg x)" or "${pi/2}"; else "".
[[nodiscard]] std::string xacro_hint(const Span& span);

/// True for "inf", "-Infinity", "nan".
[[nodiscard]] bool is_not_finite(std::string_view text);

using Vector = std::array<FileNumber, 3>;

[[nodiscard]] FileNumber make_file_number(int value);

/// The nearest double, only for comparisons with a tolerance. Magnitudes above 1e9 become 1e9,
/// magnitudes below 1e-27 become 0.
[[nodiscard]] double clamped_double(const cln::cl_RA& value);

[[nodiscard]] FileNumber negate_number(FileNumber number);

/// The number in a span. E804: no decimal number, or not finite; E903, E904: limits.
[[nodiscard]] Result<FileNumber> read_decimal(const Span& span, const Limits& limits);

/// The spans of the words in a span.
[[nodiscard]] std::vector<Span> word_spans(const Span& span);

}  // namespace elgen::urdf
