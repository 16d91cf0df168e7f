// A Decimal is a significand times a power of ten. Texts use exact integer arithmetic only, so that
// neither the locale nor libm changes a digit.
#include "numbers/exact_number.hpp"

#include <cln/dfloat.h>
#include <cln/float.h>
#include <cln/integer_io.h>
#include <cln/rational_ring.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <locale>
#include <sstream>
#include <utility>

namespace elgen {
namespace {

Decimal without_trailing_zeros(cln::cl_I significand, long exponent) {
  if (cln::zerop(significand)) return {};
  for (;;) {
    const cln::cl_I_div_t tenth = cln::truncate2(significand, 10);
    if (!cln::zerop(tenth.remainder)) return {significand, exponent};
    significand = tenth.quotient;
    ++exponent;
  }
}

/// Divides n by `factor` as often as possible; returns the number of divisions.
long remove_factor(cln::cl_I& n, int factor) {
  long count = 0;
  for (cln::cl_I_div_t part = cln::truncate2(n, factor); cln::zerop(part.remainder);
       part = cln::truncate2(n, factor)) {
    n = part.quotient;
    ++count;
  }
  return count;
}

/// floor(log10 |x|) for x != 0.
long floor_log10(const cln::cl_RA& x) {
  const cln::cl_RA magnitude = cln::abs(x);
  auto exponent = static_cast<long>(std::floor(decimal_exponent(magnitude))) - 1;
  while (magnitude * power_of_ten(-exponent - 1) >= 1) ++exponent;
  return exponent;
}

/// 3.14159…e0 with `digits` significant digits.
std::string scientific_text(const Decimal& decimal, std::size_t digits) {
  std::string text = integer_text(cln::abs(decimal.significand));
  const long exponent = static_cast<long>(text.size()) - 1 + decimal.exponent;
  text.resize(digits, '0');
  return fmt::format("{}{}.{}e{}", cln::minusp(decimal.significand) ? "-" : "", text[0],
                     text.substr(1), exponent);
}

}  // namespace

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

cln::cl_RA round_to_digits(const cln::cl_R& x, long digits) {
  if (is_rational(x)) return cln::the<cln::cl_RA>(x);
  const cln::cl_RA scale = power_of_ten(digits - static_cast<long>(decimal_exponent(x)));
  return cln::round1(x * scale) / scale;
}

std::optional<cln::cl_RA> simple_fraction(const cln::cl_R& x, const cln::cl_I& most,
                                          const cln::cl_RA& share) {
  if (cln::zerop(x)) return cln::cl_RA(0);
  cln::cl_I before_p = 0;
  cln::cl_I before_q = 1;
  cln::cl_I p = 1;
  cln::cl_I q = 0;
  for (cln::cl_R rest = x;;) {
    const cln::cl_I whole = cln::floor1(rest);
    before_p = std::exchange(p, whole * p + before_p);
    before_q = std::exchange(q, whole * q + before_q);
    if (q > most) return std::nullopt;
    const cln::cl_RA fraction = cln::cl_RA(p) / q;
    if (cln::abs(x - fraction) < cln::abs(x) * share) return fraction;
    if (rest == whole) return std::nullopt;
    rest = 1 / (rest - whole);
  }
}

cln::cl_R max_magnitude(const std::vector<cln::cl_R>& values) {
  cln::cl_R largest = 0;
  for (const cln::cl_R& value : values) largest = cln::max(largest, cln::abs(value));
  return largest;
}

cln::cl_RA exact_value(double value) {
  if (!std::isfinite(value)) return 0;
  if (std::isnormal(value)) return cln::rational(cln::cl_DF(value));
  // CLN has no subnormals, so the value is counted in units of the smallest, 2^-1074.
  constexpr int smallest = 1074;
  const auto count = static_cast<long>(std::ldexp(value, smallest));
  return cln::cl_RA(count) * cln::expt(cln::cl_RA(2), -smallest);
}

std::optional<Decimal> exact_decimal(const cln::cl_R& value, long most_places) {
  if (!is_rational(value)) return std::nullopt;
  const cln::cl_RA x = cln::rational(value);
  cln::cl_I rest = cln::denominator(x);
  const long twos = remove_factor(rest, 2);
  const long fives = remove_factor(rest, 5);
  const long places = std::max(twos, fives);
  if (rest != 1 || places > most_places) return std::nullopt;
  return without_trailing_zeros(cln::numerator(x * power_of_ten(places)), -places);
}

Decimal rounded_decimal(const cln::cl_R& value, int digits) {
  if (cln::zerop(value)) return {};
  const cln::cl_RA x = cln::rational(value);
  const long exponent = floor_log10(x) - digits + 1;
  return without_trailing_zeros(cln::round1(x * power_of_ten(-exponent)), exponent);
}

std::string integer_text(const cln::cl_I& value) {
  std::ostringstream out;
  out.imbue(std::locale::classic());
  out << value;
  return out.str();
}

std::string literal_text(const Decimal& decimal) {
  const bool negative = cln::minusp(decimal.significand);
  const std::string sign = negative ? "-" : "";
  std::string digits = integer_text(cln::abs(decimal.significand));
  // The number of digits before the decimal point.
  const long point = static_cast<long>(digits.size()) + decimal.exponent;
  if (point < -3 || point > 17) {
    const std::string fraction = digits.size() > 1 ? "." + digits.substr(1) : "";
    return fmt::format("{}{}{}e{}", sign, digits[0], fraction, point - 1);
  }
  if (point <= 0) return sign + "0." + std::string(static_cast<std::size_t>(-point), '0') + digits;
  const auto whole = static_cast<std::size_t>(point);
  if (whole >= digits.size()) {
    return sign + digits + std::string(whole - digits.size(), '0') + ".0";
  }
  return sign + digits.substr(0, whole) + "." + digits.substr(whole);
}

std::string exact_text(const cln::cl_R& value) {
  if (!is_rational(value)) return literal_text(rounded_decimal(value, 50));
  const std::optional<Decimal> decimal = exact_decimal(value);
  if (!decimal) return number_text(value);
  std::string text = literal_text(*decimal);
  if (text.size() > 2 && text.substr(text.size() - 2) == ".0") text.resize(text.size() - 2);
  return text;
}

std::string multiple_of_pi(const cln::cl_RA& multiple) {
  if (cln::zerop(multiple)) return "0";
  const cln::cl_I numerator = cln::numerator(multiple);
  const cln::cl_I denominator = cln::denominator(multiple);
  std::string text = numerator == -1 ? "-pi" : "pi";
  if (cln::abs(numerator) != 1) text = exact_text(numerator) + "*" + text;
  return denominator == 1 ? text : text + "/" + exact_text(denominator);
}

std::string number_text(const cln::cl_R& value) {
  // The value has 100 digits; 30 of them distinguish any two numbers that a file can define.
  constexpr int printed_digits = 30;
  if (cln::zerop(value)) return "0";
  if (!is_rational(value)) {
    return scientific_text(rounded_decimal(value, printed_digits), printed_digits);
  }
  const auto number = cln::the<cln::cl_RA>(value);
  const std::string numerator = integer_text(cln::numerator(number));
  const cln::cl_I denominator = cln::denominator(number);
  return denominator == 1 ? numerator : numerator + "/" + integer_text(denominator);
}

}  // namespace elgen
