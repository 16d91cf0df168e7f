// scalar_literal: shortest decimals by std::to_chars, which ignores the locale.
//
// Exact numbers are rounded correctly to binary, including subnormals and overflow. CLN's
// double_approx stops at the smallest normal number, so the significand is rounded here, as an
// integer with as many bits as the result has at its exponent. For normal numbers the hardware and
// CLN round correctly too, ten times as fast.
#include "numbers/scalar_literal.hpp"

#include <cln/float.h>
#include <cln/integer.h>
#include <cln/rational.h>

#include <algorithm>
#include <cfloat>
#include <charconv>
#include <cmath>
#include <limits>
#include <type_traits>

#include "elgen/real.hpp"
#include "numbers/exact_number.hpp"

namespace elgen {
namespace {

/// floor(log2 x) for x > 0, or one more.
long upper_exponent(const cln::cl_RA& x) {
  return static_cast<long>(cln::integer_length(cln::numerator(x))) -
         static_cast<long>(cln::integer_length(cln::denominator(x)));
}

cln::cl_RA times_power_of_two(const cln::cl_RA& x, long exponent) {
  const cln::cl_I power = cln::ash(1, cln::cl_I(std::abs(exponent)));
  return exponent >= 0 ? x * power : x / power;
}

/// Rounds x = significand * 2^exponent to the significand bits that Scalar has at this exponent.
template <class Scalar>
Scalar round_positive(const cln::cl_RA& x) {
  using Traits = std::numeric_limits<Scalar>;
  constexpr long lowest =
      Traits::min_exponent - Traits::digits;  // exponent of a subnormal's last bit
  const long estimate = upper_exponent(x);
  if (estimate > Traits::max_exponent + 1) return Traits::infinity();
  if (estimate < lowest - 2) return 0;
  // `estimate` may be one too large; then the significand would have one bit less.
  const bool too_large = times_power_of_two(x, -estimate) < 1;
  const long exponent = std::max(estimate - (too_large ? 1 : 0) - (Traits::digits - 1), lowest);
  const cln::cl_I significand = cln::round1(times_power_of_two(x, -exponent));
  // The significand has at most `digits` bits and perhaps a carry. Each half is exact, and so is
  // their sum.
  const auto high = static_cast<Scalar>(cln::cl_I_to_ulong(cln::ash(significand, -32)));
  const auto low = static_cast<Scalar>(cln::cl_I_to_ulong(cln::ldb(significand, {32, 0})));
  return std::ldexp(std::ldexp(high, 32) + low, static_cast<int>(exponent));
}

/// The correctly rounded quotient by one hardware operation. None unless the numerator is exact in
/// Scalar, and the denominator is exact or a power of two. Also none on hardware that rounds twice
/// (x87).
template <class Scalar>
std::optional<Scalar> divide_in_hardware(const cln::cl_RA& x) {
  constexpr auto digits = static_cast<uintC>(std::min(std::numeric_limits<Scalar>::digits, 62));
  const cln::cl_I numerator = cln::numerator(x);
  if (FLT_EVAL_METHOD != 0 || cln::integer_length(numerator) > digits) return std::nullopt;
  const auto dividend = static_cast<Scalar>(cln::cl_I_to_long(numerator));
  const cln::cl_I divisor = cln::denominator(x);
  if (const auto power = cln::power2p(divisor)) {  // power2p gives the exponent plus one
    return std::ldexp(dividend, 1 - static_cast<int>(power));
  }
  if (cln::integer_length(divisor) > digits) return std::nullopt;
  return dividend / static_cast<Scalar>(cln::cl_I_to_long(divisor));
}

/// |x| rounded to Scalar, for floats x of two kinds; otherwise none. If Scalar is double, CLN
/// rounds floats in the range of normal doubles. Floats far beyond all built-in types become 0 or
/// infinity, because their exact fractions might not fit into memory.
template <class Scalar>
std::optional<Scalar> round_by_exponent(const cln::cl_R& x) {
  constexpr std::int64_t normal = 1'000;
  constexpr std::int64_t beyond_all = 40'000;
  if (is_rational(x)) return std::nullopt;
  const auto exponent = static_cast<std::int64_t>(cln::float_exponent(cln::the<cln::cl_F>(x)));
  if constexpr (std::is_same_v<Scalar, double>) {
    if (std::abs(exponent) < normal) return std::abs(cln::double_approx(x));
  }
  if (std::abs(exponent) < beyond_all) return std::nullopt;
  return exponent < 0 ? 0 : std::numeric_limits<Scalar>::infinity();
}

template <class Scalar>
Scalar round_to(const cln::cl_R& value) {
  if (const std::optional<Scalar> magnitude = round_by_exponent<Scalar>(value)) {
    return cln::minusp(value) ? -*magnitude : *magnitude;
  }
  const cln::cl_RA x = cln::rational(value);
  if (const std::optional<Scalar> quotient = divide_in_hardware<Scalar>(x)) return *quotient;
  return cln::minusp(x) ? -round_positive<Scalar>(-x) : round_positive<Scalar>(x);
}

template <class Scalar>
ScalarFit fit_of_type(const cln::cl_R& value) {
  const Scalar nearest = std::abs(ScalarTraits<Scalar>::from_real(value));
  if (nearest > std::numeric_limits<Scalar>::max()) return ScalarFit::too_large;
  const bool is_subnormal = nearest < std::numeric_limits<Scalar>::min();
  return is_subnormal && !cln::zerop(value) ? ScalarFit::too_small : ScalarFit::fits;
}

template <class Scalar>
std::string shortest_text(const cln::cl_R& value) {
  char buffer[64];
  const Scalar nearest = ScalarTraits<Scalar>::from_real(value);
  const std::to_chars_result end = std::to_chars(buffer, buffer + sizeof buffer, nearest);
  std::string text(buffer, end.ptr);
  const bool is_floating = text.find_first_of(".e") != std::string::npos;
  return is_floating ? text : text + ".0";
}

/// The exact decimal of `value` if it has at most 17 digits, as many as a double; otherwise none.
std::optional<std::string> readable_literal(const cln::cl_R& value) {
  constexpr std::size_t readable_digits = 17;
  const std::optional<Decimal> decimal = exact_decimal(value);
  const bool is_readable =
      decimal && integer_text(cln::abs(decimal->significand)).size() <= readable_digits;
  return is_readable ? std::optional(literal_text(*decimal)) : std::nullopt;
}

}  // namespace

float ScalarTraits<float>::from_real(const cln::cl_R& value) { return round_to<float>(value); }
double ScalarTraits<double>::from_real(const cln::cl_R& value) { return round_to<double>(value); }
long double ScalarTraits<long double>::from_real(const cln::cl_R& value) {
  return round_to<long double>(value);
}

ScalarFit scalar_fit(const cln::cl_R& value, ScalarKind scalar) {
  switch (scalar) {
    case ScalarKind::single_precision:
      return fit_of_type<float>(value);
    case ScalarKind::double_precision:
      return fit_of_type<double>(value);
    case ScalarKind::long_double:
      return fit_of_type<long double>(value);
  }
  return ScalarFit::fits;
}

std::string shortest_literal(const cln::cl_R& value, ScalarKind scalar) {
  switch (scalar) {
    case ScalarKind::single_precision:
      return shortest_text<float>(value);
    case ScalarKind::double_precision:
      return shortest_text<double>(value);
    case ScalarKind::long_double:
      // The user's compiler reads this literal, and its long double may have 113 bits.
      return literal_text(rounded_decimal(value, 40));
  }
  return "";
}

std::string scalar_literal(const cln::cl_R& value, ScalarKind scalar) {
  const std::optional<std::string> readable = readable_literal(value);
  return readable ? *readable : shortest_literal(value, scalar);
}

std::string signed_literal(const cln::cl_R& value, ScalarKind scalar) {
  return (cln::minusp(value) ? "-" : "") + scalar_literal(cln::abs(value), scalar);
}

std::optional<std::string> exact_float_literal(const cln::cl_R& value) {
  if (!is_rational(value) || scalar_fit(value, ScalarKind::single_precision) != ScalarFit::fits) {
    return std::nullopt;
  }
  const float nearest = ScalarTraits<float>::from_real(value);
  const bool is_exact = exact_value(static_cast<double>(nearest)) == cln::rational(value);
  return is_exact ? readable_literal(value) : std::nullopt;
}

}  // namespace elgen
