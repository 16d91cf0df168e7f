// Real functions: exact if the value is rational and obvious, otherwise CLN floats.
//
// CLN reduces the argument of sin and exp with only as many digits as the argument has. Arguments
// are therefore extended by as many digits as they have before the point; results are rounded to
// working precision.
#include "oracle/real_functions.hpp"

#include <cln/integer.h>
#include <cln/rational.h>

#include "numbers/enclosed_number.hpp"
#include "numbers/exact_number.hpp"

namespace elgen::oracle {
namespace {

using cln::cl_F;
using cln::cl_I;
using cln::cl_R;
using cln::cl_RA;

/// exp() of a larger number is far beyond every scalar type, and CLN would need minutes for it.
const cl_R largest_exponent = 1'000'000;

/// For |x| beyond this, tanh(x) is +-1 to working precision: 1 - tanh(x) < 2 exp(-2 x). Each
/// further digit adds 2 to the bound on |x|, and exp(-4) < 0.1.
cl_R tanh_saturation() { return 200 + 2 * ExtraDigits::requested_digits(); }

/// Angles above 2^20000 throw NumberTooLarge; no built-in scalar holds such angles.
constexpr long largest_angle_exponent = 20'000;

unsigned current_digits() { return working_digits + ExtraDigits::requested_digits(); }

cln::float_format_t working_format() { return cln::float_format(current_digits()); }

/// `x` as a float of working precision, plus as many digits as `x` has before the decimal point.
cl_F extend_precision(const cl_R& x) {
  if (is_rational(x)) {
    const cl_I integer_part = cln::truncate1(x);
    const auto digits = static_cast<unsigned>(cln::integer_length(integer_part)) / 3 + 1;
    return cln::cl_float(x, cln::float_format(current_digits() + digits));
  }
  const cl_F f = cln::the<cl_F>(x);
  const auto bits = cln::float_exponent(f);
  if (bits <= 0) return f;
  if (bits > largest_angle_exponent) throw NumberTooLarge("argument too large to reduce");
  const unsigned digits = static_cast<unsigned>(bits) / 3 + 1;
  ExtraDigits::report_lost(digits);
  return cln::cl_float(f, cln::float_format(current_digits() + digits));
}

cl_R round_to_working(const cl_R& x) {
  return is_rational(x) ? x : cl_R(cln::cl_float(cln::the<cl_F>(x), working_format()));
}

/// Reports |x| as the number of digits that e^x may hide in a sum. e^x is 10^(0.43 x), so even the
/// square of e^x hides fewer than |x| digits.
void report_hidden_digits(const cl_R& x) {
  const cl_R size = cln::min(cln::abs(x), largest_exponent);
  ExtraDigits::report_hidden(cln::cl_I_to_uint(cln::ceiling1(size)));
}

cl_R widen_exponent(const cl_R& x) {
  if (cln::abs(x) > largest_exponent) throw NumberTooLarge("exponential too large");
  report_hidden_digits(x);
  return extend_precision(x);
}

cl_R root_of_one_minus_square(const cl_R& x) {
  if (cln::abs(x) > 1) throw OutsideDomain("argument of asin or acos beyond 1");
  const cl_R square = (1 - x) * (1 + x);
  return cln::zerop(square) ? cl_R(0) : real_power(square, cl_RA(1) / 2);
}

cl_R angle(const cl_R& sine, const cl_R& cosine) {
  if (cln::zerop(sine) && cln::zerop(cosine)) throw OutsideDomain("atan2(0, 0)");
  if (sine == 0 && is_rational(sine) && cosine > 0) return 0;
  return cln::atan(as_float(cosine), as_float(sine));
}

cl_R hyperbolic_tangent(const cl_R& x) {
  report_hidden_digits(x);
  if (cln::abs(x) > tanh_saturation()) return as_float(cln::signum(x));
  return cln::tanh(extend_precision(x));
}

cl_R logarithm(const cl_R& x) {
  if (x <= 0) throw OutsideDomain("logarithm of zero or less");
  return x == 1 && is_rational(x) ? cl_R(0) : cl_R(cln::ln(as_float(x)));
}

/// log(1 + x). For small x, 1 + x would lose digits, so the series 2 (z + z^3/3 + z^5/5 + …), z =
/// x/(2 + x), is summed.
cl_R log_one_plus(const cl_R& x) {
  if (cln::abs(x) > cl_RA(1) / 2) return logarithm(1 + x);
  const cl_R z = as_float(x / (2 + x));
  cl_R power = z;
  cl_R sum = z;
  for (int n = 3;; n += 2) {
    power = power * z * z;
    const cl_R next = sum + power / n;
    if (next == sum) return 2 * sum;
    sum = next;
  }
}

/// asinh(x) = sgn(x) log(1 + |x| + x^2/(1 + sqrt(1 + x^2)))
cl_R area_hyperbolic_sine(const cl_R& x) {
  if (cln::zerop(x)) return x;
  const cl_R size = cln::abs(x);
  const cl_R root = real_power(1 + size * size, cl_RA(1) / 2);
  return cln::signum(x) * log_one_plus(size + size * size / (1 + root));
}

/// e^x - 1. For small x the difference would lose digits, so the series x + x^2/2! + … is summed.
cl_R exponential_less_one(const cl_R& x) {
  if (x < -largest_exponent) {
    report_hidden_digits(x);
    return as_float(-1);
  }
  if (cln::abs(x) > cl_RA(1) / 2) return cln::exp(widen_exponent(x)) - 1;
  cl_R term = as_float(x);
  cl_R sum = term;
  for (int n = 2;; ++n) {
    term = term * x / n;
    const cl_R next = sum + term;
    if (next == sum) return sum;
    sum = next;
  }
}

/// c_0 = cos(x) or c_1 = sin(x)/x; if hyperbolic, the same functions of i x.
cl_R base_stumpff_value(const cl_F& x, bool is_odd, bool is_hyperbolic) {
  if (is_hyperbolic) return is_odd ? cln::sinh(x) / x : cln::cosh(x);
  return is_odd ? cln::sin(x) / x : cln::cos(x);
}

/// c_k(x) = sum over n of (-1)^n x^(2 n)/(2 n + k)!, k = |order|; without the signs (-1)^n if order
/// < 0. For small x the sum is evaluated, with additional digits for its largest term. For large x
/// c_(n+2) = (1/n! - c_n)/s is used, s = x^2 (-x^2 if order < 0); this recurrence loses no digits.
cl_R stumpff_sum(const cl_R& x, const cl_R& order) {
  const bool is_hyperbolic = cln::minusp(order);
  const unsigned k = cln::cl_I_to_uint(cln::round1(cln::abs(order)));
  const auto reciprocal_factorial = [](unsigned n) { return cl_RA(1) / cln::factorial(n); };
  if (x == 0) return reciprocal_factorial(k);
  const unsigned widest = 3 * k + 100;
  if (cln::abs(x) > widest) {
    const cl_F argument = cln::the<cl_F>(is_hyperbolic ? widen_exponent(x) : extend_precision(x));
    const cl_R square = is_hyperbolic ? -argument * argument : argument * argument;
    cl_R value = base_stumpff_value(argument, k % 2 != 0, is_hyperbolic);
    for (unsigned n = k % 2; n < k; n += 2) value = (reciprocal_factorial(n) - value) / square;
    return value;
  }
  const cl_R argument = cln::cl_float(x, cln::float_format(current_digits() + widest));
  cl_R term = cln::cl_float(reciprocal_factorial(k), cln::float_format(current_digits() + widest));
  cl_R sum = term;
  for (unsigned n = k + 1;; n += 2) {
    term = term * (is_hyperbolic ? argument : -argument) * argument / (n * (n + 1));
    const cl_R next = sum + term;
    if (next == sum) return sum;
    sum = next;
  }
}

/// The value of a function other than sin and cos.
cl_R uncached_value(FunctionId function, const cl_R& x, const cl_R& y) {
  switch (function) {
    case FunctionId::sin:
    case FunctionId::cos:
      break;
    case FunctionId::tan:
      return cln::tan(extend_precision(x));
    case FunctionId::asin:
      return angle(x, root_of_one_minus_square(x));
    case FunctionId::acos:
      return angle(root_of_one_minus_square(x), x);
    case FunctionId::atan:
      return cln::atan(as_float(x));
    case FunctionId::atan2:
      return angle(x, y);
    case FunctionId::sinh:
      return cln::sinh(widen_exponent(x));
    case FunctionId::cosh:
      return cln::cosh(widen_exponent(x));
    case FunctionId::tanh:
      return hyperbolic_tangent(x);
    case FunctionId::asinh:
      return area_hyperbolic_sine(x);
    case FunctionId::exp:
      return cln::exp(widen_exponent(x));
    case FunctionId::log:
      return logarithm(x);
    case FunctionId::log1p:
      return log_one_plus(x);
    case FunctionId::expm1:
      return exponential_less_one(x);
    case FunctionId::hypot:
      return x == 0 && y == 0 ? cl_R(0) : real_power(x * x + y * y, cl_RA(1) / 2);
    case FunctionId::stumpff:
      return stumpff_sum(x, y);
    case FunctionId::abs:
      return cln::abs(x);
    case FunctionId::sign:
      return cln::signum(x);
    case FunctionId::min:
      return cln::min(x, y);
    case FunctionId::max:
      return cln::max(x, y);
  }
  throw OutsideDomain("function without a value");
}

}  // namespace

cl_R as_float(const cl_R& x) {
  return is_rational(x) ? cl_R(cln::cl_float(x, working_format())) : x;
}

cl_R shorten_rationals(const cl_R& x, unsigned max_bits) {
  if (!is_rational(x)) return x;
  const cl_RA rational = cln::the<cl_RA>(x);
  const auto bits = cln::integer_length(cln::numerator(rational)) +
                    cln::integer_length(cln::denominator(rational));
  return bits <= max_bits ? x : as_float(x);
}

cl_R real_pi() { return cln::pi(working_format()); }

cl_R quotient(const cl_R& x, const cl_R& y) {
  if (cln::zerop(y)) throw OutsideDomain("division by zero");
  return x / y;
}

cl_R real_power(const cl_R& x, const cl_RA& exponent) {
  if (x <= 0) throw OutsideDomain("broken power of zero or less");
  const cl_I numerator = cln::numerator(exponent);
  const cl_I denominator = cln::denominator(exponent);
  if (denominator == 2) {
    cl_RA exact_root;
    const bool exact = is_rational(x) && cln::sqrtp(cln::the<cl_RA>(x), &exact_root);
    const cl_R root = exact ? cl_R(exact_root) : cl_R(cln::sqrt(as_float(x)));
    return cln::expt(root, numerator);
  }
  return cln::exp(cln::ln(as_float(x)) * exponent);
}

cl_R RealFunctions::value(FunctionId function, const cl_R& x, const cl_R& y) {
  const FunctionRow& row = function_row(function);
  if (row.arity == 1 && is_rational(x) && cln::zerop(x)) {
    if (row.exact_argument == 0) return row.exact_value;
    if (function == FunctionId::acos) return real_pi() / 2;
  }
  const auto entry = memoised_values_.find(Call{function, x, y});
  return entry != memoised_values_.end() ? entry->second : compute_and_store(function, x, y);
}

/// Computes, stores and returns a value; stores sine and cosine together: derivatives need both.
cl_R RealFunctions::compute_and_store(FunctionId function, const cl_R& x, const cl_R& y) {
  if (!is_circular(function)) {
    return memoised_values_[Call{function, x, y}] =
               round_to_working(uncached_value(function, x, y));
  }
  const cln::cos_sin_t both = cos_sin_of(extend_precision(x));
  const cl_R sine = memoised_values_[Call{FunctionId::sin, x, y}] = round_to_working(both.sin);
  const cl_R cosine = memoised_values_[Call{FunctionId::cos, x, y}] = round_to_working(both.cos);
  return function == FunctionId::sin ? sine : cosine;
}

}  // namespace elgen::oracle
