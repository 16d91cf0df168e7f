// Significand times a power of the base.
#include "numbers/exact_number.hpp"

#include <cln/float.h>
#include <cln/integer.h>
#include <cln/rational_ring.h>

#include <cmath>

namespace elgen {

bool is_rational(const cln::cl_R& value) { return cln:: instanceof (value, cln::cl_RA_ring); }

cln::cl_RA power_of_ten(long exponent) { return cln::expt(cln::cl_RA(10), cln::cl_I(exponent)); }

double decimal_exponent(const cln::cl_R& x) {
  constexpr double log10_of_2 = 0.30102999566398120;
  if (cln::zerop(x)) return 0;
  if (!is_rational(x)) {
    return static_cast<double>(cln::float_exponent(cln::the<cln::cl_F>(x))) * log10_of_2;
  }
  const auto r = cln::the<cln::cl_RA>(x);
  const auto bits = [](const cln::cl_I& n) { return static_cast<double>(cln::integer_length(n)); };
  return (bits(cln::numerator(r)) - bits(cln::denominator(r))) * log10_of_2;
}

cln::cl_RA rounded(const cln::cl_R& x, long digits) {
  if (is_rational(x)) return cln::the<cln::cl_RA>(x);
  const cln::cl_RA scale = power_of_ten(digits - static_cast<long>(decimal_exponent(x)));
  return cln::round1(x * scale) / scale;
}

cln::cl_R largest_of(const std::vector<cln::cl_R>& values) {
  cln::cl_R largest = 0;
  for (const cln::cl_R& value : values) largest = cln::max(largest, cln::abs(value));
  return largest;
}

cln::cl_RA exact_value(double value) {
  if (!std::isfinite(value)) return 0;
  // CLN has no denormals, so the exponent is applied to an integer significand.
  int exponent = 0;
  const double fraction = std::frexp(value, &exponent);
  const auto significand = static_cast<long>(std::ldexp(fraction, 53));
  return cln::cl_RA(significand) * cln::expt(cln::cl_RA(2), exponent - 53);
}

}  // namespace elgen
