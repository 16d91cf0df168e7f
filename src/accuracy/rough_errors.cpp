// The rules of rough errors.
#include "accuracy/rough_errors.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "numbers/dual.hpp"
#include "numbers/exact_number.hpp"

namespace elgen {
namespace {

constexpr double u = 0x1p-53;
constexpr double not_known = std::numeric_limits<double>::quiet_NaN();

/// An operand that is right to one part in 1000 leaves first-order errors right within a few.
constexpr double certain = 0x1p-10;

/// Errors of `x` that count where it is divided by, or where a slope is taken at it.
double known_error(const RoughError& x) {
  return x.error * u <= certain * std::abs(x.value) ? x.error : not_known;
}

/// Magnitude of the derivative by one argument.
double slope(FunctionId function, const RoughError& x, const RoughError& y, bool by_first) {
  if (function == FunctionId::sin) return std::abs(std::cos(x.value));
  if (function == FunctionId::cos) return std::abs(std::sin(x.value));
  const Dual<double> first{x.value, by_first ? 1.0 : 0.0};
  const Dual<double> second{y.value, by_first ? 0.0 : 1.0};
  return std::abs(interpreter::call(function, first, second).slope);
}

}  // namespace

RoughError RoughRules::constant(const Constant& constant) const {
  const double value = ScalarTraits<double>::from_real(constant.value);
  return {value, exact_value(value) == constant.value ? 0 : std::abs(value)};
}

RoughError RoughRules::add(const RoughError& x, const RoughError& y) const {
  const double value = x.value + y.value;
  return {value, x.error + y.error + std::abs(value)};
}

RoughError RoughRules::multiply(const RoughError& x, const RoughError& y) const {
  const double value = x.value * y.value;
  return {value, x.error * std::abs(y.value) + y.error * std::abs(x.value) + std::abs(value)};
}

RoughError RoughRules::divide(const RoughError& x, const RoughError& y) const {
  const double value = x.value / y.value;
  return {value,
          (x.error + std::abs(value) * known_error(y)) / std::abs(y.value) + std::abs(value)};
}

RoughError RoughRules::square_root(const RoughError& x) const {
  const double value = std::sqrt(x.value);
  return {value, known_error(x) / (value + value) + value};
}

RoughError RoughRules::call(FunctionId function, const RoughError& x, const RoughError& y) const {
  const double value = interpreter::call(function, x.value, y.value);
  const bool is_binary = function_row(function).arity == 2;
  const RoughError& second = is_binary ? y : x;
  if (is_kinked(function)) return {value, std::max(x.error, second.error)};
  const double own = is_circular(function) ? x.error : known_error(x);
  double error = std::abs(value) + slope(function, x, y, true) * own;
  if (is_binary) error += slope(function, x, y, false) * known_error(y);
  return {value, error};
}

}  // namespace elgen
