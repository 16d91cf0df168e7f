// Exact numbers: powers of ten, sizes, and binary numbers as the rationals they are.
#pragma once

#include <cln/rational.h>
#include <cln/real.h>

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

/// The largest magnitude; 0 where there is none.
[[nodiscard]] cln::cl_R largest_of(const std::vector<cln::cl_R>& values);

/// The rational a binary number is; 0 where it is none.
[[nodiscard]] cln::cl_RA exact_value(double value);

}  // namespace elgen
