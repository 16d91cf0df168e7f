// Enclosed numbers: each operation is computed in floats of many digits, and its error bound in 17
// digits.
#include "numbers/enclosed_number.hpp"

#include <cln/integer.h>
#include <cln/rational.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <deque>

#include "numbers/exact_number.hpp"

namespace elgen {
namespace {

using cln::cl_F;
using cln::cl_I;
using cln::cl_R;
using cln::cl_RA;

/// Digits that cover CLN's own rounding errors of a few ulp.
constexpr int guard_digits = 10;

/// Larger arguments of exp, sinh and cosh give values beyond 10^±10000.
constexpr long largest_exponent = 23'025;

cln::float_format_t bound_format() { return cln::float_format(17); }

cl_R largest_magnitude(const EnclosedNumber& x) { return cln::abs(x.value) + x.error; }
/// The least magnitude; <= 0 if the enclosure contains 0.
cl_R least_magnitude(const EnclosedNumber& x) { return cln::abs(x.value) - x.error; }

/// log(1 + x) = log(s) x/(s - 1) with s = 1 + x rounded. log(s) and s - 1 have nearly the same
/// relative error, which cancels in the quotient (W. Kahan).
cl_F log_one_plus(const cl_F& x) {
  const cl_F sum = 1 + x;
  const cl_F kept = sum - 1;
  return cln::zerop(kept) ? x : cln::ln(sum) * x / kept;
}

/// asinh(x) = log(|x| + sqrt(1 + x^2)) with the sign of x, without cancellation near 0.
cl_F area_hyperbolic_sine(const cl_F& x) {
  const cl_F size = cln::abs(x);
  const cl_F square = size * size;
  const cl_F value = log_one_plus(size + square / (1 + cln::sqrt(1 + square)));
  return cln::minusp(x) ? -value : value;
}

/// e^x - 1 = 2 sinh(x/2) e^(x/2) for |x| <= 1, so that a small x loses no digits.
cl_F exp_minus_one(const cl_F& x) {
  if (cln::abs(x) > cl_R(1)) return cln::exp(x) - 1;
  const cl_F half = x / 2;
  return cln::scale_float(cln::sinh(half) * cln::exp(half), 1);
}

/// c_k(x) for k > 0; a negative `order` gives c_|order|(i x). Sums the power series if its terms
/// decrease from the first term on. Otherwise uses
///
///     c_1 = sin(x)/x     c_2 = 2 (sin(x/2)/x)^2     c_(n+2) = (1/n! - c_n)/x^2
cl_F stumpff_function(const cl_F& x, int order) {
  const int k = std::abs(order);
  const auto reciprocal_factorial = [&x](int n) {
    return cln::recip(cln::cl_float(cln::factorial(static_cast<unsigned>(n)), x));
  };
  const cl_F square = order < 0 ? -x * x : x * x;
  if (cln::abs(square) < cln::cl_float(std::max(1, k * (k - 1)), x)) {
    cl_F term = reciprocal_factorial(k);
    cl_F sum = term;
    for (int n = k + 1;; n += 2) {
      term = -term * square / (n * (n + 1));
      const cl_F next = sum + term;
      if (next == sum) return sum;
      sum = next;
    }
  }
  const bool is_odd = k % 2 != 0;
  const cl_F argument = is_odd ? x : x / 2;
  const cl_F ratio = (order < 0 ? cln::sinh(argument) : cln::sin(argument)) / x;
  cl_F value = is_odd ? ratio : cln::scale_float(ratio * ratio, 1);
  for (int n = is_odd ? 1 : 2; n < k; n += 2) value = (reciprocal_factorial(n) - value) / square;
  return value;
}

/// The order k of stumpff(x, k).
int stumpff_order(const cl_R& k) { return cln::cl_I_to_int(cln::round1(k)); }

bool is_zero(const EnclosedNumber& x) { return is_exact(x) && cln::zerop(x.value); }

/// An angle x is a pole of tan if the enclosure of cos(x) contains 0, and the error of cos(x)
/// exceeds |cos(x)| by at most this distance.
const cl_R& pole_distance() {
  static const cl_R distance = power_of_ten(-60);
  return distance;
}

}  // namespace

bool is_exact(const EnclosedNumber& x) { return cln::zerop(x.error); }

EnclosedNumber operator-(const EnclosedNumber& x) { return {-x.value, x.error}; }

std::optional<int> sign_of(const EnclosedNumber& x) {
  if (cln::plusp(least_magnitude(x))) return cln::minusp(x.value) ? -1 : 1;
  return is_zero(x) ? std::optional(0) : std::nullopt;
}

EnclosedArithmetic::EnclosedArithmetic(int digits)
    : format_(cln::float_format(static_cast<std::uintptr_t>(digits))),
      roundoff_(cln::cl_float(power_of_ten(guard_digits - digits), bound_format())) {}

/// `value` with an error bound: `error` plus the rounding error of `value`, plus a summand that
/// covers the rounding of the bound itself.
EnclosedNumber EnclosedArithmetic::add_rounding_error(const cl_R& value, const cl_R& error) const {
  const cl_F bound = cln::cl_float(error + roundoff_ * cln::abs(value), bound_format());
  return {value, bound + bound * cln::cl_float(power_of_ten(-15), bound_format())};
}

/// The argument as a float, as CLN's functions need it.
EnclosedNumber EnclosedArithmetic::to_float(const EnclosedNumber& x) const {
  return is_rational(x.value) ? add_rounding_error(as_float(x.value), x.error) : x;
}

/// f(x), given |f'| <= slope on the enclosure of x.
EnclosedNumber EnclosedArithmetic::call_with_slope(FunctionId function, const EnclosedNumber& x,
                                                   const cl_R& slope) const {
  const cl_F argument = as_float(x.value);
  return add_rounding_error(function_value(function, argument, argument), x.error * slope);
}

EnclosedNumber EnclosedArithmetic::pi() const { return add_rounding_error(cln::pi(format_), 0); }

EnclosedNumber EnclosedArithmetic::sum(const EnclosedNumber& x, const EnclosedNumber& y) const {
  const cl_R value = x.value + y.value;
  if (is_exact(x) && is_exact(y)) return {value, 0};
  return add_rounding_error(value, x.error + y.error);
}

EnclosedNumber EnclosedArithmetic::product(const EnclosedNumber& x, const EnclosedNumber& y) const {
  const cl_R value = x.value * y.value;
  if (is_exact(x) && is_exact(y)) return {value, 0};
  return add_rounding_error(value, largest_magnitude(x) * y.error + cln::abs(y.value) * x.error);
}

/// |1/x - 1/y| = |x - y|/|x y|
EnclosedResult EnclosedArithmetic::reciprocal(const EnclosedNumber& x) const {
  if (!cln::plusp(least_magnitude(x)))
    return is_zero(x) ? NoValueReason::undefined : NoValueReason::unknown;
  const cl_R value = cln::recip(x.value);
  if (is_exact(x)) return EnclosedNumber{value, 0};
  return add_rounding_error(value, x.error / (cln::abs(x.value) * least_magnitude(x)));
}

EnclosedResult EnclosedArithmetic::integer_power(const EnclosedNumber& x,
                                                 const cl_I& exponent) const {
  EnclosedNumber result{1, 0};
  EnclosedNumber square = x;
  for (cl_I rest = cln::abs(exponent); rest > 0; rest = cln::ash(rest, -1)) {
    if (cln::oddp(rest)) result = product(result, square);
    if (rest > 1) square = product(square, square);
  }
  return cln::minusp(exponent) ? reciprocal(result) : EnclosedResult(result);
}

/// sqrt(x); the error bound follows from |sqrt x - sqrt y| <= |x - y|/sqrt y.
EnclosedNumber EnclosedArithmetic::square_root(const EnclosedNumber& x) const {
  return add_rounding_error(cln::sqrt(as_float(x.value)),
                            x.error / cln::sqrt(as_float(least_magnitude(x))));
}

/// x^(p/q); exact if the root is rational.
EnclosedResult EnclosedArithmetic::power(const EnclosedNumber& x, const cl_RA& exponent) const {
  const cl_I q = cln::denominator(exponent);
  if (is_zero(x) && cln::plusp(exponent)) return EnclosedNumber{0, 0};
  if (is_zero(x)) return NoValueReason::undefined;
  const double size = decimal_exponent(x.value) * cln::double_approx(exponent);
  if (std::abs(size) > largest_decimal_exponent) return NoValueReason::too_large;
  if (q == 1) return integer_power(x, cln::numerator(exponent));
  const std::optional<int> sign = sign_of(x);
  if (!sign) return NoValueReason::unknown;
  if (*sign < 0) return NoValueReason::complex;
  cl_RA root;
  if (is_exact(x) && is_rational(x.value) && cln::rootp(cln::the<cl_RA>(x.value), q, &root)) {
    return integer_power({root, 0}, cln::numerator(exponent));
  }
  const EnclosedNumber base = to_float(x);
  if (q == 2) return integer_power(square_root(base), cln::numerator(exponent));
  return exponential(FunctionId::exp,
                     product(*logarithm(FunctionId::log, base).number, {exponent, 0}));
}

EnclosedResult EnclosedArithmetic::tangent(const EnclosedNumber& x) const {
  const cl_R cosine = cln::abs(cln::cos(as_float(x.value))) - x.error - roundoff_;
  if (!cln::plusp(cosine))
    return -cosine > pole_distance() ? NoValueReason::unknown : NoValueReason::undefined;
  return call_with_slope(FunctionId::tan, x, cln::recip(cosine * cosine));
}

/// asin or acos. The slope 1/sqrt(1 - x^2) is unbounded at ±1, so x must be exact there.
EnclosedResult EnclosedArithmetic::inverse_circular(FunctionId function,
                                                    const EnclosedNumber& x) const {
  if (is_exact(x) && cln::abs(x.value) == 1) return call_with_slope(function, x, 0);
  const EnclosedNumber sine = to_float(x);
  const cl_R square = (1 - x.value) * (1 + x.value);  // cos(asin x)^2
  const cl_R error = sine.error * (2 * cln::abs(x.value) + sine.error);
  if (square < -error) return NoValueReason::complex;
  if (square <= error) return NoValueReason::unknown;
  return call_with_slope(function, sine, cln::recip(cln::sqrt(as_float(square - error))));
}

/// The angle of (x, y). Undefined at the origin; unknown near the branch cut unless y is exactly 0.
EnclosedResult EnclosedArithmetic::arc_tangent_2(const EnclosedNumber& y,
                                                 const EnclosedNumber& x) const {
  if (is_zero(x) && is_zero(y)) return NoValueReason::undefined;
  const bool is_right = cln::plusp(x.value - x.error);
  if (is_zero(y) && is_right) return EnclosedNumber{0, 0};
  const bool is_on_cut = is_zero(y) && cln::minusp(x.value + x.error);
  if (!is_right && !cln::plusp(least_magnitude(y)) && !is_on_cut) return NoValueReason::unknown;
  const EnclosedNumber across = to_float(y);
  const EnclosedNumber along = to_float(x);
  const cl_R distance = cln::max(least_magnitude(across), least_magnitude(along));
  const cl_R value =
      function_value(FunctionId::atan2, as_float(across.value), as_float(along.value));
  return add_rounding_error(value, (across.error + along.error) / distance);
}

/// log(x), or log(1 + x) if `function` is log1p.
EnclosedResult EnclosedArithmetic::logarithm(FunctionId function, const EnclosedNumber& x) const {
  const EnclosedNumber argument = function == FunctionId::log ? x : sum(x, {1, 0});
  if (is_zero(argument)) return NoValueReason::undefined;
  const std::optional<int> sign = sign_of(argument);
  if (!sign) return NoValueReason::unknown;
  if (*sign < 0) return NoValueReason::complex;
  return call_with_slope(function, to_float(x), cln::recip(least_magnitude(argument)));
}

EnclosedResult EnclosedArithmetic::exponential(FunctionId function, const EnclosedNumber& x) const {
  const EnclosedNumber argument = to_float(x);
  if (largest_magnitude(argument) > largest_exponent) {
    // At arguments of this size, tanh equals ±1 to all digits, and expm1 equals -1 if x < 0.
    const bool is_flat =
        function == FunctionId::tanh || (function == FunctionId::expm1 && cln::minusp(x.value));
    return is_flat ? EnclosedResult(add_rounding_error(cln::signum(as_float(x.value)), 0))
                   : NoValueReason::too_large;
  }
  if (function == FunctionId::tanh) return call_with_slope(function, argument, 1);
  // The slopes of exp and expm1 are largest at the right end; the slopes of sinh and cosh grow with
  // |x|.
  const bool falls = function == FunctionId::exp || function == FunctionId::expm1;
  const cl_R end = falls ? argument.value + argument.error : largest_magnitude(argument);
  return call_with_slope(function, argument, 2 * cln::exp(cln::cl_float(end, bound_format())));
}

/// c_k(x); the error bound follows from |c_k'| <= 1/(k + 1)! for k > 0, and <= sinh |x| for k < 0.
EnclosedResult EnclosedArithmetic::stumpff(const EnclosedNumber& x, const EnclosedNumber& k) const {
  const EnclosedNumber argument = to_float(x);
  const bool grows = cln::minusp(k.value);
  if (grows && largest_magnitude(argument) > largest_exponent) return NoValueReason::too_large;
  const cl_R end = grows ? largest_magnitude(argument) : cl_R(0);
  const cl_R slope = cln::exp(cln::cl_float(end, bound_format()));
  return add_rounding_error(
      function_value(FunctionId::stumpff, as_float(x.value), as_float(k.value)),
      argument.error * slope);
}

EnclosedResult EnclosedArithmetic::call(FunctionId function, const EnclosedNumber& x,
                                        const EnclosedNumber& y) const {
  const bool is_binary = function_row(function).arity == 2;
  const EnclosedNumber& last = is_binary ? y : x;
  if (is_exact(x) && is_rational(x.value) && is_exact(last) && is_rational(last.value)) {
    const auto known =
        exact_function_value(function, cln::the<cl_RA>(x.value), cln::the<cl_RA>(last.value));
    if (known) return EnclosedNumber{*known, 0};
  }
  switch (function) {
    case FunctionId::sin:
    case FunctionId::cos:
    case FunctionId::atan:
    case FunctionId::asinh:
      return call_with_slope(function, to_float(x), 1);
    case FunctionId::tan:
      return tangent(to_float(x));
    case FunctionId::asin:
    case FunctionId::acos:
      return inverse_circular(function, x);
    case FunctionId::atan2:
      return arc_tangent_2(x, y);
    case FunctionId::sinh:
    case FunctionId::cosh:
    case FunctionId::tanh:
    case FunctionId::exp:
    case FunctionId::expm1:
      return exponential(function, x);
    case FunctionId::log:
    case FunctionId::log1p:
      return logarithm(function, x);
    case FunctionId::hypot:
      return add_rounding_error(function_value(function, as_float(x.value), as_float(y.value)),
                                to_float(x).error + to_float(y).error);
    case FunctionId::stumpff:
      return stumpff(x, y);
    case FunctionId::abs:
      return EnclosedNumber{cln::abs(x.value), x.error};
    case FunctionId::sign: {
      const std::optional<int> sign = sign_of(x);
      return sign ? EnclosedResult(EnclosedNumber{*sign, 0}) : NoValueReason::unknown;
    }
    case FunctionId::min:
      return EnclosedNumber{cln::min(x.value, y.value), cln::max(x.error, y.error)};
    case FunctionId::max:
      return EnclosedNumber{cln::max(x.value, y.value), cln::max(x.error, y.error)};
  }
  return NoValueReason::unknown;
}

cl_R function_value(FunctionId function, const cl_F& x, const cl_F& y) {
  const auto cofunction = [&x] { return cln::sqrt((1 - x) * (1 + x)); };
  switch (function) {
#define ELGEN_VALUE(name, ...) \
  case FunctionId::name:       \
    return __VA_ARGS__;
    ELGEN_VALUE(sin, cos_sin_of(x).sin)
    ELGEN_VALUE(cos, cos_sin_of(x).cos)
    ELGEN_VALUE(tan, cln::tan(x))
    ELGEN_VALUE(asin, cln::atan(cofunction(), x))
    ELGEN_VALUE(acos, cln::atan(x, cofunction()))
    ELGEN_VALUE(atan, cln::atan(x))
    ELGEN_VALUE(atan2, cln::atan(y, x))
    ELGEN_VALUE(sinh, cln::sinh(x))
    ELGEN_VALUE(cosh, cln::cosh(x))
    ELGEN_VALUE(tanh, cln::tanh(x))
    ELGEN_VALUE(asinh, area_hyperbolic_sine(x))
    ELGEN_VALUE(exp, cln::exp(x))
    ELGEN_VALUE(log, cln::ln(x))
    ELGEN_VALUE(log1p, log_one_plus(x))
    ELGEN_VALUE(expm1, exp_minus_one(x))
    ELGEN_VALUE(hypot, cln::sqrt(x * x + y * y))
    ELGEN_VALUE(stumpff, stumpff_function(x, stumpff_order(y)))
    ELGEN_VALUE(abs, cln::abs(x))
    ELGEN_VALUE(sign, cln::signum(x))
    ELGEN_VALUE(min, cln::min(x, y))
    ELGEN_VALUE(max, cln::max(x, y))
#undef ELGEN_VALUE
  }
  return x;
}

cln::cos_sin_t cos_sin_of(const cl_F& x) {
  struct Known {
    cl_F x;
    cln::cos_sin_t both;
  };
  constexpr std::size_t most = 16;  // enough for a few angles in two precisions
  thread_local std::deque<Known> latest;
  const auto known = std::ranges::find_if(latest, [&x](const Known& other) {
    return cln::float_digits(other.x) == cln::float_digits(x) && other.x == x;
  });
  if (known != latest.end()) return known->both;
  latest.push_front({x, cln::cos_sin(x)});
  if (latest.size() > most) latest.pop_back();
  return latest.front().both;
}

std::optional<cl_RA> exact_function_value(FunctionId function, const cl_RA& x, const cl_RA& y) {
  const FunctionRow& row = function_row(function);
  const auto at = [&x](const cl_RA& place, const cl_RA& value) {
    return x == place ? std::optional<cl_RA>(value) : std::nullopt;
  };
  if (row.arity == 1) return at(row.exact_argument, row.exact_value);
  if (function == FunctionId::atan2 && cln::plusp(y)) return at(0, 0);
  if (function == FunctionId::stumpff) {
    const auto k = static_cast<unsigned>(std::abs(stumpff_order(y)));
    return at(0, cln::recip(cl_RA(cln::factorial(k))));
  }
  cl_RA root;
  const bool is_root = function == FunctionId::hypot && cln::sqrtp(x * x + y * y, &root);
  return is_root ? std::optional(root) : std::nullopt;
}

}  // namespace elgen
