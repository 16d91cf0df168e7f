// decimal: exact integer arithmetic only, so that no locale and no libm decides a digit.
#include "decimal.hpp"

#include <cln/integer_io.h>
#include <cln/rational.h>
#include <cln/rational_ring.h>
#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <locale>
#include <sstream>

#include "elgen/evaluate.hpp"

namespace elgen {
namespace {

constexpr int maximal_digits = 400;

/// x * 10^exponent
cln::cl_RA shifted(const cln::cl_RA& x, long exponent) {
  if (exponent == 0) return x;
  return exponent > 0 ? x * power_of_ten(exponent) : x / power_of_ten(-exponent);
}

Decimal without_trailing_zeros(cln::cl_I significand, long exponent) {
  if (cln::zerop(significand)) return {};
  for (;;) {
    const cln::cl_I_div_t tenth = cln::truncate2(significand, 10);
    if (!cln::zerop(tenth.remainder)) return {significand, exponent};
    significand = tenth.quotient;
    ++exponent;
  }
}

/// How often `factor` divides n; n is left without it.
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
long decimal_exponent(const cln::cl_RA& x) {
  const cln::cl_RA magnitude = cln::abs(x);
  const auto numerator = static_cast<double>(cln::integer_length(cln::numerator(magnitude)));
  const auto denominator = static_cast<double>(cln::integer_length(cln::denominator(magnitude)));
  // Within one of the truth, because the bit lengths are.
  auto exponent = static_cast<long>(std::floor((numerator - denominator) * 0.30103)) - 1;
  while (shifted(magnitude, -exponent - 1) >= 1) ++exponent;
  return exponent;
}

template <class Scalar>
Fit fit_in(const cln::cl_R& value) {
  const Scalar nearest = std::abs(ScalarTraits<Scalar>::from_real(value));
  if (nearest > std::numeric_limits<Scalar>::max()) return Fit::too_large;
  const bool is_subnormal = nearest < std::numeric_limits<Scalar>::min();
  return is_subnormal && !cln::zerop(value) ? Fit::too_small : Fit::fits;
}

template <class Scalar>
std::string shortest_in(const cln::cl_R& value) {
  char buffer[64];
  const Scalar nearest = ScalarTraits<Scalar>::from_real(value);
  const std::to_chars_result end = std::to_chars(buffer, buffer + sizeof buffer, nearest);
  std::string text(buffer, end.ptr);
  const bool is_floating = text.find_first_of(".e") != std::string::npos;
  return is_floating ? text : text + ".0";
}

}  // namespace

cln::cl_I power_of_ten(long exponent) {
  return exponent == 0 ? cln::cl_I(1) : cln::expt_pos(cln::cl_I(10), cln::cl_I(exponent));
}

bool is_rational(const cln::cl_R& value) { return cln:: instanceof (value, cln::cl_RA_ring); }

std::optional<Decimal> exact_decimal(const cln::cl_R& value) {
  if (!is_rational(value)) return std::nullopt;
  const cln::cl_RA x = cln::rational(value);
  cln::cl_I rest = cln::denominator(x);
  const long twos = remove_factor(rest, 2);
  const long fives = remove_factor(rest, 5);
  const long exponent = std::max(twos, fives);
  if (rest != 1 || exponent > maximal_digits) return std::nullopt;
  return without_trailing_zeros(cln::numerator(shifted(x, exponent)), -exponent);
}

Decimal rounded_decimal(const cln::cl_R& value, int digits) {
  if (cln::zerop(value)) return {};
  const cln::cl_RA x = cln::rational(value);
  const long exponent = decimal_exponent(x) - digits + 1;
  return without_trailing_zeros(cln::round1(shifted(x, -exponent)), exponent);
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
  const long point =
      static_cast<long>(digits.size()) + decimal.exponent;  // before the first digit: 0
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
  const cln::cl_RA x = cln::rational(value);
  if (const std::optional<Decimal> decimal = exact_decimal(value)) {
    std::string text = literal_text(*decimal);
    if (text.size() > 2 && text.substr(text.size() - 2) == ".0") text.resize(text.size() - 2);
    return text;
  }
  return integer_text(cln::numerator(x)) + "/" + integer_text(cln::denominator(x));
}

Fit fit(const cln::cl_R& value, ScalarKind scalar) {
  switch (scalar) {
    case ScalarKind::single_precision:
      return fit_in<float>(value);
    case ScalarKind::double_precision:
      return fit_in<double>(value);
    case ScalarKind::long_double:
      return fit_in<long double>(value);
  }
  return Fit::fits;
}

std::string scalar_name(ScalarKind scalar) {
  switch (scalar) {
    case ScalarKind::single_precision:
      return "float";
    case ScalarKind::double_precision:
      return "double";
    case ScalarKind::long_double:
      return "long double";
  }
  return "";
}

std::string shortest_literal(const cln::cl_R& value, ScalarKind scalar) {
  switch (scalar) {
    case ScalarKind::single_precision:
      return shortest_in<float>(value);
    case ScalarKind::double_precision:
      return shortest_in<double>(value);
    case ScalarKind::long_double:
      // A literal is read by the user's compiler, whose long double may have 113 bits.
      return literal_text(rounded_decimal(value, 40));
  }
  return "";
}

std::optional<std::string> exact_in_float(const cln::cl_R& value) {
  if (!is_rational(value) || fit(value, ScalarKind::single_precision) != Fit::fits) {
    return std::nullopt;
  }
  const float nearest = ScalarTraits<float>::from_real(value);
  const std::optional<Decimal> decimal = exact_decimal(value);
  const bool is_exact = cln::rational(cln::cl_float(nearest)) == cln::rational(value);
  if (!decimal || !is_exact) return std::nullopt;
  const std::string text = literal_text(*decimal);
  if (integer_text(cln::abs(decimal->significand)).size() > 17) return std::nullopt;
  return text;
}

}  // namespace elgen
