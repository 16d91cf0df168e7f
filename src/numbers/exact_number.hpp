// Exact numbers: powers of ten, sizes, binary numbers as the rationals they are, and decimal texts,
// the same in every locale and process.
#pragma once

#include <cln/integer.h>
#include <cln/rational.h>
#include <cln/real.h>

#include <optional>
#include <string>
#include <vector>

namespace elgen {

[[nodiscard]] bool is_rational(const cln::cl_R& value);

/// 10^exponent. (CLN reads decimals as short floats, which underflow.)
[[nodiscard]] cln::cl_RA power_of_ten(long exponent);

/// log10 |x| to within one, of numbers of any size; 0 of 0.
[[nodiscard]] double decimal_exponent(const cln::cl_R& x);

/// The rational number of about so many significant digits, or one more; x itself where it is
/// rational.
[[nodiscard]] cln::cl_RA rounded(const cln::cl_R& x, long digits);

/// The simplest fraction within `share` of x, relative to x, whose denominator is at most `most`:
/// the first such convergent of its continued fraction. None without such a convergent; 0 for 0.
[[nodiscard]] std::optional<cln::cl_RA> simple_fraction(const cln::cl_R& x, const cln::cl_I& most,
                                                        const cln::cl_RA& share);

/// The largest magnitude; 0 where there is none.
[[nodiscard]] cln::cl_R largest_of(const std::vector<cln::cl_R>& values);

/// The rational a binary number is; 0 where it is none.
[[nodiscard]] cln::cl_RA exact_value(double value);

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
