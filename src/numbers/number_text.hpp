// Numbers as text: exact numbers -> decimal texts, the same in every locale and process.
#pragma once

#include <cln/integer.h>
#include <cln/real.h>

#include <optional>
#include <string>

#include "numbers/exact_number.hpp"

namespace elgen {

/// significand * 10^exponent; the significand has no trailing zeros (0 is 0 * 10^0).
struct Decimal {
  cln::cl_I significand = 0;
  long exponent = 0;
};

/// The decimal that equals the value; none for irrational ones, 1/3, or more than so many places.
[[nodiscard]] std::optional<Decimal> exact_decimal(const cln::cl_R& value, long most_places = 400);

/// The value rounded to so many significant digits.
[[nodiscard]] Decimal rounded_decimal(const cln::cl_R& value, int digits);

/// The decimal digits of an integer.
[[nodiscard]] std::string integer_text(const cln::cl_I& value);

/// "9.81", "2.0", "1e-300": a floating literal of C and C++ without suffix.
[[nodiscard]] std::string literal_text(const Decimal& decimal);

/// The exact value to read: "9.81", "1/3"; 50 digits of what is irrational.
[[nodiscard]] std::string exact_text(const cln::cl_R& value);

/// "3", "-1/2"; a number that is no rational as a decimal of 30 digits, "3.14159…e0".
[[nodiscard]] std::string number_text(const cln::cl_R& value);

}  // namespace elgen
