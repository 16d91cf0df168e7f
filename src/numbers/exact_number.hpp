// Exact numbers: powers of ten, magnitudes, doubles as rationals, and decimal texts that are the
// same in every locale and process.
#pragma once

#include <cln/integer.h>
#include <cln/rational.h>
#include <cln/real.h>

#include <optional>
#include <string>
#include <vector>

namespace elgen {

[[nodiscard]] bool is_rational(const cln::cl_R& value);

/// 10^exponent. CLN's own reader would read decimals as short floats, which underflow.
[[nodiscard]] cln::cl_RA power_of_ten(long exponent);

/// log10 |x| to within one, for x of any magnitude; 0 for x = 0.
[[nodiscard]] double decimal_exponent(const cln::cl_R& x);

/// x rounded to `digits` or `digits` + 1 significant digits; a rational x is returned unchanged.
[[nodiscard]] cln::cl_RA round_to_digits(const cln::cl_R& x, long digits);

/// The first convergent p/q of the continued fraction of x with |x - p/q| < share |x| and q <=
/// most. None if no convergent satisfies both conditions; 0 for x = 0.
[[nodiscard]] std::optional<cln::cl_RA> simple_fraction(const cln::cl_R& x, const cln::cl_I& most,
                                                        const cln::cl_RA& share);

/// The largest magnitude; 0 if `values` is empty.
[[nodiscard]] cln::cl_R max_magnitude(const std::vector<cln::cl_R>& values);

/// The rational equal to `value`; 0 for infinity and NaN.
[[nodiscard]] cln::cl_RA exact_value(double value);

/// significand * 10^exponent; the significand has no trailing zeros (0 is 0 * 10^0).
struct Decimal {
  cln::cl_I significand = 0;
  long exponent = 0;
};

/// The decimal equal to `value`. None if `value` is irrational, is a fraction such as 1/3, or needs
/// more than `most_places` decimal places.
[[nodiscard]] std::optional<Decimal> exact_decimal(const cln::cl_R& value, long most_places = 400);

/// `value` rounded to `digits` significant digits.
[[nodiscard]] Decimal rounded_decimal(const cln::cl_R& value, int digits);

/// The decimal digits, after "-" if the value is negative.
[[nodiscard]] std::string integer_text(const cln::cl_I& value);

/// "9.81", "2.0", "1e-300": a floating literal of C and C++ without suffix.
[[nodiscard]] std::string literal_text(const Decimal& decimal);

/// The exact value for readers: "9.81", "1/3". An irrational value has 50 digits.
[[nodiscard]] std::string exact_text(const cln::cl_R& value);

/// `multiple` times pi in the model language: "pi/2", "-3*pi/4", "0".
[[nodiscard]] std::string multiple_of_pi(const cln::cl_RA& multiple);

/// "3", "-1/2"; an irrational number as a decimal of 30 digits, "3.14159…e0".
[[nodiscard]] std::string number_text(const cln::cl_R& value);

}  // namespace elgen
