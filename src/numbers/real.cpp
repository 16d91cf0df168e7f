// Real: CLN floats of 64 digits or more. Arguments outside the domain of a function give
// `undefined`.
#include "elgen/real.hpp"

#include <cln/exception.h>
#include <cln/real.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>

#include "numbers/enclosed_number.hpp"
#include "numbers/exact_number.hpp"
#include "numbers/more_digits.hpp"

namespace elgen {
namespace {

constexpr unsigned basic_digits = 64;

unsigned current_digits() { return basic_digits + ExtraDigits::requested_digits(); }

const cln::cl_F& number(const Real& x) { return x.value(); }

/// The result of `operation`; undefined outside the domain or beyond CLN's range of exponents.
template <class Operation>
Real evaluate_in_domain(bool in_domain, const Operation& operation) {
  if (!in_domain) return Real::undefined();
  try {
    return Real(operation());
  } catch (const cln::runtime_exception&) {
    return Real::undefined();
  }
}

bool are_defined(const Real& x, const Real& y) { return x.is_defined() && y.is_defined(); }

/// x with as many extra digits as x has before its decimal point. After reduction by a multiple of
/// pi, x still has the digits of Real.
cln::cl_F extend_digits(const Real& x) {
  const auto exponent = std::max(std::int64_t{0}, std::int64_t{cln::float_exponent(number(x))});
  const auto before_point = static_cast<unsigned>(exponent / 3);
  ExtraDigits::report_lost(before_point);
  return cln::cl_float(number(x), cln::float_format(current_digits() + before_point));
}

/// The largest binary exponent of an angle that is reduced. Built-in floats have smaller exponents.
constexpr std::int64_t maximal_angle_exponent = 20'000;

bool is_periodic(FunctionId function) {
  return is_circular(function) || function == FunctionId::tan || function == FunctionId::stumpff;
}

/// The largest binary exponent of an exponential's argument. At larger arguments, CLN overflows
/// without an error.
constexpr std::int64_t maximal_exponent = 30;

/// The value of tanh or expm1 at a large argument if the value is ±1 to all digits; otherwise none.
std::optional<Real> limit_at_infinity(FunctionId function, const cln::cl_F& x) {
  const std::optional<LimitsAtInfinity>& far = function_row(function).limits_at_infinity;
  if (!far || cln::float_exponent(x) < maximal_exponent) return std::nullopt;
  const double limit = cln::minusp(x) ? far->left : far->right;
  return std::abs(limit) == 1 ? std::optional(Real(exact_value(limit))) : std::nullopt;
}

bool is_in_domain(FunctionId function, const cln::cl_F& x) {
  const FunctionRow& row = function_row(function);
  if (is_periodic(function)) return cln::float_exponent(x) < maximal_angle_exponent;
  if (row.limits_at_infinity) return cln::float_exponent(x) < maximal_exponent;
  switch (row.domain) {
    case FunctionDomain::all:
      break;
    case FunctionDomain::up_to_one:
      return cln::abs(x) <= cln::cl_R(1);
    case FunctionDomain::above_zero:
      return cln::plusp(x);
    case FunctionDomain::above_minus_one:
      return x > cln::cl_R(-1);
  }
  return true;
}

Real call_function(FunctionId function, const Real& x, const Real& y) {
  if (!are_defined(x, y)) return Real::undefined();
  if (is_kinked(function)) return Real(function_value(function, number(x), number(y)));
  const FunctionId far = growth_function(function, cln::minusp(number(y)));
  if (const auto limit = limit_at_infinity(function, number(x))) return *limit;
  const bool is_origin = cln::zerop(number(x)) && cln::zerop(number(y));
  if (function == FunctionId::atan2 && is_origin) return Real();  // 0, as in the C library
  return evaluate_in_domain(is_in_domain(far, number(x)), [&] {
    return function_value(function, is_periodic(far) ? extend_digits(x) : number(x), number(y));
  });
}

}  // namespace

cln::float_format_t Real::format() { return cln::float_format(current_digits()); }

Real Real::undefined() {
  Real result;
  result.defined_ = false;
  return result;
}

Real operator-(const Real& x) {
  return evaluate_in_domain(x.is_defined(), [&] { return -number(x); });
}
Real operator+(const Real& x, const Real& y) {
  return evaluate_in_domain(are_defined(x, y), [&] { return number(x) + number(y); });
}
Real operator-(const Real& x, const Real& y) {
  return evaluate_in_domain(are_defined(x, y), [&] { return number(x) - number(y); });
}
Real operator*(const Real& x, const Real& y) {
  return evaluate_in_domain(are_defined(x, y), [&] { return number(x) * number(y); });
}
Real operator/(const Real& x, const Real& y) {
  return evaluate_in_domain(are_defined(x, y) && !cln::zerop(number(y)),
                            [&] { return number(x) / number(y); });
}
Real sqrt(const Real& x) {
  return evaluate_in_domain(x.is_defined() && !cln::minusp(number(x)),
                            [&] { return cln::sqrt(number(x)); });
}

bool operator<(const Real& x, const Real& y) { return are_defined(x, y) && number(x) < number(y); }
bool operator<=(const Real& x, const Real& y) {
  return are_defined(x, y) && number(x) <= number(y);
}
bool is_zero(const Real& x) { return x.is_defined() && cln::zerop(x.value()); }

bool is_near(const Real& x, const Real& y, long digits) {
  return abs(x - y) < Real(power_of_ten(-digits));
}

#define ELGEN_REAL_1(name) \
  Real name(const Real& x) { return call_function(FunctionId::name, x, x); }
#define ELGEN_REAL_2(name) \
  Real name(const Real& x, const Real& y) { return call_function(FunctionId::name, x, y); }
#define ELGEN_FUNCTION(name, arity) ELGEN_REAL_##arity(name)
#include "elgen/functions.def"
#undef ELGEN_FUNCTION
#undef ELGEN_REAL_2
#undef ELGEN_REAL_1

}  // namespace elgen
