// Real: CLN floats of 64 digits or more with the domain of every function guarded.
#include <cln/exception.h>
#include <cln/real.h>

#include <algorithm>
#include <cstdint>
#include <utility>

#include "base/more_digits.hpp"
#include "elgen/evaluate.hpp"

namespace elgen {
namespace {

constexpr unsigned basic_digits = 64;

/// Agreement is asked for to 50 digits of a bound that knows the slope of a sine: these may go.
constexpr unsigned spare_digits = 10;

/// Of RealPrecision: digits beyond the basic ones, and those that angles met have before the point.
thread_local unsigned more_digits = 0;
thread_local unsigned lost_digits = 0;

unsigned digits() { return basic_digits + MoreDigits::count() + more_digits; }

const cln::cl_F& number(const Real& x) { return x.value(); }

/// f(x) where x is defined and in the domain, and the result within CLN's range of exponents.
template <class Operation>
Real guarded(bool in_domain, const Operation& operation) {
  if (!in_domain) return Real::undefined();
  try {
    return Real(operation());
  } catch (const cln::runtime_exception&) {
    return Real::undefined();
  }
}

bool both(const Real& x, const Real& y) { return x.is_defined() && y.is_defined(); }

/// sqrt(1 - x^2), undefined outside of [-1, 1].
Real cofunction(const Real& x) {
  const Real one(1);
  return sqrt((one - x) * (one + x));
}

/// x with so many digits more that reduction by a multiple of pi leaves as many as Real has.
cln::cl_F lengthened(const Real& x) {
  const auto exponent = std::max(std::int64_t{0}, std::int64_t{cln::float_exponent(number(x))});
  const auto before_point = static_cast<unsigned>(exponent / 3);
  lost_digits = std::max(lost_digits, before_point);
  return cln::cl_float(number(x), cln::float_format(digits() + before_point));
}

/// The largest exponent of an angle that is reduced: beyond the range of every built-in float.
constexpr std::int64_t maximal_angle_exponent = 20'000;

bool is_angle(const Real& x) {
  return x.is_defined() && cln::float_exponent(number(x)) < maximal_angle_exponent;
}

/// Beyond, CLN's exponents overflow without a word.
bool is_exponent(const Real& x) {
  constexpr std::int64_t maximal_exponent = 30;  // |x| < 2^30
  return x.is_defined() && cln::float_exponent(number(x)) < maximal_exponent;
}

}  // namespace

cln::float_format_t Real::format() { return cln::float_format(digits()); }

RealPrecision::RealPrecision() : outer_(std::exchange(more_digits, 0)) { lost_digits = 0; }

RealPrecision::~RealPrecision() { more_digits = outer_; }

bool RealPrecision::grows() {
  const unsigned lost = std::exchange(lost_digits, 0);
  if (lost <= more_digits + spare_digits) return false;
  more_digits = lost;
  return true;
}

Real Real::undefined() {
  Real result;
  result.defined_ = false;
  return result;
}

Real operator-(const Real& x) {
  return guarded(x.is_defined(), [&] { return -number(x); });
}
Real operator+(const Real& x, const Real& y) {
  return guarded(both(x, y), [&] { return number(x) + number(y); });
}
Real operator-(const Real& x, const Real& y) {
  return guarded(both(x, y), [&] { return number(x) - number(y); });
}
Real operator*(const Real& x, const Real& y) {
  return guarded(both(x, y), [&] { return number(x) * number(y); });
}
Real operator/(const Real& x, const Real& y) {
  return guarded(both(x, y) && !cln::zerop(number(y)), [&] { return number(x) / number(y); });
}
Real sqrt(const Real& x) {
  return guarded(x.is_defined() && !cln::minusp(number(x)), [&] { return cln::sqrt(number(x)); });
}
Real sin(const Real& x) {
  return guarded(is_angle(x), [&] { return cln::sin(lengthened(x)); });
}
Real cos(const Real& x) {
  return guarded(is_angle(x), [&] { return cln::cos(lengthened(x)); });
}
Real tan(const Real& x) { return sin(x) / cos(x); }
Real asin(const Real& x) { return atan2(x, cofunction(x)); }
Real acos(const Real& x) { return atan2(cofunction(x), x); }
Real atan(const Real& x) {
  return guarded(x.is_defined(), [&] { return cln::atan(number(x)); });
}
Real atan2(const Real& y, const Real& x) {
  const bool origin = both(x, y) && cln::zerop(number(x)) && cln::zerop(number(y));
  if (origin) return Real();  // as the C library has it
  return guarded(both(x, y), [&] { return cln::atan(number(x), number(y)); });
}
Real sinh(const Real& x) {
  return guarded(is_exponent(x), [&] { return cln::sinh(number(x)); });
}
Real cosh(const Real& x) {
  return guarded(is_exponent(x), [&] { return cln::cosh(number(x)); });
}
Real tanh(const Real& x) {
  return guarded(is_exponent(x), [&] { return cln::tanh(number(x)); });
}
Real exp(const Real& x) {
  return guarded(is_exponent(x), [&] { return cln::exp(number(x)); });
}
Real log(const Real& x) {
  return guarded(x.is_defined() && cln::plusp(number(x)), [&] { return cln::ln(number(x)); });
}
Real abs(const Real& x) {
  return guarded(x.is_defined(), [&] { return cln::abs(number(x)); });
}
Real sign(const Real& x) {
  return guarded(x.is_defined(), [&] { return cln::cl_R(cln::signum(number(x))); });
}
Real min(const Real& x, const Real& y) {
  return guarded(both(x, y), [&] { return cln::min(number(x), number(y)); });
}
Real max(const Real& x, const Real& y) {
  return guarded(both(x, y), [&] { return cln::max(number(x), number(y)); });
}

}  // namespace elgen
