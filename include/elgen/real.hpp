// Real: floats of at least 64 digits. ScalarTraits: conversion of exact numbers to a scalar type.
// interpreter: for built-in floats, the functions of functions.def that the standard library lacks.
#pragma once

#include <cln/float.h>
#include <cln/real.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <limits>
#include <type_traits>

#include "elgen/functions.hpp"

namespace elgen {

/// Converts exact numbers to a scalar type; specialised for float, double, long double, cl_F, …
template <class Scalar>
struct ScalarTraits;

/// Rounds `value` to the nearest number of type float, double or long double.
template <>
struct ScalarTraits<float> {
  [[nodiscard]] static float from_real(const cln::cl_R& value);
};
template <>
struct ScalarTraits<double> {
  [[nodiscard]] static double from_real(const cln::cl_R& value);
};
template <>
struct ScalarTraits<long double> {
  [[nodiscard]] static long double from_real(const cln::cl_R& value);
};

/// The nearest double.
[[nodiscard]] inline double to_double(const cln::cl_R& value) {
  return ScalarTraits<double>::from_real(value);
}

/// A float of 64 decimal digits (or more: numbers/more_digits.hpp). The value "undefined" (1/0,
/// sqrt(-1)) propagates like NaN.
class Real {
 public:
  Real() : Real(cln::cl_R(0)) {}
  explicit Real(const cln::cl_R& value) : value_(cln::cl_float(value, format())) {}

  [[nodiscard]] static cln::float_format_t format();
  [[nodiscard]] static Real undefined();

  [[nodiscard]] bool is_defined() const { return defined_; }
  [[nodiscard]] const cln::cl_F& value() const { return value_; }

 private:
  cln::cl_F value_;
  bool defined_ = true;
};

[[nodiscard]] Real operator-(const Real& x);
[[nodiscard]] Real operator+(const Real& x, const Real& y);
[[nodiscard]] Real operator-(const Real& x, const Real& y);
[[nodiscard]] Real operator*(const Real& x, const Real& y);
[[nodiscard]] Real operator/(const Real& x, const Real& y);
[[nodiscard]] Real sqrt(const Real& x);

/// x < y; false if an operand is undefined, as for NaN.
[[nodiscard]] bool operator<(const Real& x, const Real& y);
[[nodiscard]] bool operator<=(const Real& x, const Real& y);
[[nodiscard]] inline bool operator>(const Real& x, const Real& y) { return y < x; }
[[nodiscard]] bool is_zero(const Real& x);

/// True if |x - y| < 10^-digits. Two closed forms that agree to 1e-40, in arithmetic of 64 digits,
/// are candidates for a proof that they are equal.
[[nodiscard]] bool is_near(const Real& x, const Real& y, long digits = 40);

#define ELGEN_REAL_1(name) [[nodiscard]] Real name(const Real& x);
#define ELGEN_REAL_2(name) [[nodiscard]] Real name(const Real& x, const Real& y);
#define ELGEN_FUNCTION(name, arity) ELGEN_REAL_##arity(name)
#include "elgen/functions.def"
#undef ELGEN_FUNCTION
#undef ELGEN_REAL_2
#undef ELGEN_REAL_1

template <>
struct ScalarTraits<Real> {
  [[nodiscard]] static Real from_real(const cln::cl_R& value) { return Real(value); }
};

namespace interpreter {

#define ELGEN_FUNCTION(name, arity) using std::name;
#define ELGEN_OWN_FUNCTION(name, arity)
#include "elgen/functions.def"
#undef ELGEN_FUNCTION

/// Kinked functions for built-in floats. sign(0) = 0 and sign(NaN) = NaN. min and max return x if x
/// or y is NaN.
template <class Scalar>
requires std::is_floating_point_v<Scalar>
[[nodiscard]] Scalar sign(Scalar x) {
  if (x > 0) return 1;
  if (x < 0) return -1;
  return x;
}
template <class Scalar>
requires std::is_floating_point_v<Scalar>
[[nodiscard]] Scalar min(Scalar x, Scalar y) { return y < x ? y : x; }
template <class Scalar>
requires std::is_floating_point_v<Scalar>
[[nodiscard]] Scalar max(Scalar x, Scalar y) { return x < y ? y : x; }

/// stumpff(x, k) = c_k(x), with the operations of the emitted code. If x^2 < max(1, k (k - 1)), the
/// series is summed to the degree that suffices at the end of this range. Otherwise
///
///     c_1 = sin(x)/x,   c_2 = 2 (sin(x/2)/x)^2,   c_(n+2) = (1/n! - c_n)/x^2
///
/// For k < 0, x is replaced by i x: sin becomes sinh, and x^2 becomes -x^2.
template <class Scalar>
requires std::is_floating_point_v<Scalar>
[[nodiscard]] Scalar stumpff(Scalar x, Scalar order) {
  const int k = std::abs(static_cast<int>(order));
  const int largest = std::max(1, k * (k - 1));
  const Scalar turned = order < 0 ? -x : x;
  const Scalar square = x * turned;
  if (x * x < static_cast<Scalar>(largest)) {
    double size = 1;
    for (int i = 0; i < std::numeric_limits<Scalar>::max_digits10; ++i) size *= 10;
    int n = k;
    for (; size > 1; n += 2) size = size * largest / ((n + 1) * (n + 2));
    Scalar sum = 1;
    for (; n > k; n -= 2) sum = 1 - square * sum / static_cast<Scalar>(n * (n - 1));
    for (; n > 1; --n) sum = sum / static_cast<Scalar>(n);
    return sum;
  }
  const bool is_odd = k % 2 != 0;
  const Scalar argument = is_odd ? x : x / 2;
  const Scalar ratio = (order < 0 ? std::sinh(argument) : std::sin(argument)) / x;
  Scalar value = is_odd ? ratio : 2 * ratio * ratio;
  auto factorial = static_cast<Scalar>(is_odd ? 1 : 2);
  for (int n = is_odd ? 1 : 2; n < k; n += 2) {
    value = (1 / factorial - value) / x / turned;
    factorial = factorial * static_cast<Scalar>((n + 1) * (n + 2));
  }
  return value;
}

}  // namespace interpreter

}  // namespace elgen
