// Numbers as text. CLN prints rationals exactly; floats are scaled to integers first, so that
// neither CLN's exponent letters nor the locale show.
#include "number_text.hpp"

#include <cln/float_io.h>
#include <cln/integer_io.h>
#include <cln/rational_io.h>
#include <cln/rational_ring.h>
#include <cln/real.h>

#include <cmath>
#include <sstream>

namespace elgen {
namespace {

constexpr int printed_digits = 30;  // of 100: told apart by everything a file can say

std::string integer_text(const cln::cl_I& value) {
  std::ostringstream out;
  out.imbue(std::locale::classic());
  cln::fprintdecimal(out, value);
  return out.str();
}

cln::cl_RA power_of_ten(long exponent) { return cln::expt(cln::cl_RA(10), cln::cl_I(exponent)); }

/// The decimal exponent e with 10^e <= value < 10^(e+1).
long decimal_exponent(const cln::cl_R& value) {
  const double bits = static_cast<double>(cln::float_exponent(cln::cl_float(value)));
  auto exponent = static_cast<long>(std::floor((bits - 1) * 0.30102999566398120));
  while (power_of_ten(exponent) > value) --exponent;
  while (power_of_ten(exponent + 1) <= value) ++exponent;
  return exponent;
}

std::string float_text(const cln::cl_R& value) {
  const cln::cl_R magnitude = cln::abs(value);
  long exponent = decimal_exponent(magnitude);
  cln::cl_I rounded = cln::round1(magnitude * power_of_ten(printed_digits - 1 - exponent));
  // 9.99…9 may round to one digit more.
  if (rounded == power_of_ten(printed_digits)) {
    rounded = cln::numerator(power_of_ten(printed_digits - 1));
    ++exponent;
  }
  const std::string digits = integer_text(rounded);
  return (cln::minusp(value) ? "-" : "") + digits.substr(0, 1) + "." + digits.substr(1) + "e" +
         std::to_string(exponent);
}

}  // namespace

std::string number_text(const cln::cl_R& value) {
  if (cln::zerop(value)) {
    return "0";
  }
  if (!cln:: instanceof (value, cln::cl_RA_ring)) {
    return float_text(value);
  }
  const cln::cl_RA number = cln::the<cln::cl_RA>(value);
  const std::string numerator = integer_text(cln::numerator(number));
  return cln::denominator(number) == 1 ? numerator
                                       : numerator + "/" + integer_text(cln::denominator(number));
}

}  // namespace elgen
