// decimal: exact numbers -> decimal texts, and what built-in scalars make of them.
#pragma once

#include <cln/integer.h>
#include <cln/real.h>

#include <optional>
#include <string>

#include "elgen/scene.hpp"

namespace elgen {

/// significand * 10^exponent; the significand has no trailing zeros (0 is 0 * 10^0).
struct Decimal {
  cln::cl_I significand = 0;
  long exponent = 0;
};

/// 10^exponent for exponent >= 0.
[[nodiscard]] cln::cl_I power_of_ten(long exponent);

[[nodiscard]] bool is_rational(const cln::cl_R& value);

/// The decimal that equals the value; none for irrational ones, 1/3, or more than 400 digits.
[[nodiscard]] std::optional<Decimal> exact_decimal(const cln::cl_R& value);

/// The value rounded to so many significant digits.
[[nodiscard]] Decimal rounded_decimal(const cln::cl_R& value, int digits);

/// "9.81", "2.0", "1e-300": a floating literal of C and C++ without suffix.
[[nodiscard]] std::string literal_text(const Decimal& decimal);

/// The decimal digits of an integer.
[[nodiscard]] std::string integer_text(const cln::cl_I& value);

/// The exact value to read: "9.81", "1/3"; 50 digits of what is irrational.
[[nodiscard]] std::string exact_text(const cln::cl_R& value);

/// How a value fares in a built-in scalar. `too_small` is 0 or a subnormal where the value is not
/// 0.
enum class Fit : std::uint8_t { fits, too_large, too_small };

[[nodiscard]] Fit fit(const cln::cl_R& value, ScalarKind scalar);

/// "float", "double", "long double"
[[nodiscard]] std::string scalar_name(ScalarKind scalar);

/// The shortest decimal that the scalar reads back as its nearest value; the value must fit.
[[nodiscard]] std::string shortest_literal(const cln::cl_R& value, ScalarKind scalar);

/// The value itself where a float holds it exactly (0, 2, -1/2) and 17 digits write it.
[[nodiscard]] std::optional<std::string> exact_in_float(const cln::cl_R& value);

}  // namespace elgen
