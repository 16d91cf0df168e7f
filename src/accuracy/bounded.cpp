// The rules of error bounds.
#include "accuracy/bounded.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace elgen {
namespace {

template <class Scalar>
Real real(Scalar x) {
  return Real(exact_value(static_cast<double>(x)));
}

template <class Scalar>
Rounding rounding_of() {
  using Limits = std::numeric_limits<Scalar>;
  const Real u = real(Limits::epsilon()) / Real(2);
  return {u, real(Limits::denorm_min()) / u, real(Limits::min()), real(Limits::max()) / Real(16),
          [](const cln::cl_R& value) { return real(ScalarTraits<Scalar>::from_real(value)); }};
}

Bound computed(const Real& value, const Real& bound, const Rounding& rounding) {
  // Beyond CLN's exponents a bound says nothing; what is left are the digits that 60 leave to
  // spare.
  if (!bound.is_defined()) return {value, abs(value) * Real(power_of_ten(30)), false, true};
  const bool tiny = abs(value) < rounding.smallest;
  const bool underflows = tiny && !cln::zerop(value.value());
  return {value, tiny ? bound + rounding.underflow : bound, false, false, 0, underflows};
}

Bound inherit(Bound result, const Bound& x, const Bound& y) {
  result.lost = result.lost || x.lost || y.lost;
  result.underflows = result.underflows || x.underflows || y.underflows;
  result.roundings = std::max(x.roundings, y.roundings);
  return result;
}

/// The same where B has all roundings, so that none is counted.
Bound inherit_all(Bound result, const Bound& x, const Bound& y) {
  result = inherit(std::move(result), x, y);
  result.roundings = 0;
  return result;
}

/// Known to within a tenth, with the promised 8 u B.
bool is_certain(const Bound& x, const Rounding& rounding) {
  return x.exact || x.bound * rounding.roundoff * Real(80) < abs(x.value);
}

/// f, f' and f'' in one argument, the other held.
Dual<Dual<Real>> with_derivatives(FunctionId function, const Bound& x, const Bound& y,
                                  bool in_first) {
  const Dual<Real> moving_x{x.value, Real(in_first ? 1 : 0)};
  const Dual<Real> moving_y{y.value, Real(in_first ? 0 : 1)};
  const Dual<Dual<Real>> first{moving_x, {moving_x.slope, Real()}};
  const Dual<Dual<Real>> second{moving_y, {moving_y.slope, Real()}};
  return interpreter::call(function, first, second);
}

/// |f'| A + 1/2 u max|f''| A^2 of one argument.
Real argument_part(FunctionId function, const Bound& x, const Bound& y, bool in_first,
                   const Rounding& rounding) {
  const Bound& argument = in_first ? x : y;
  if (argument.exact) return {};
  const Dual<Dual<Real>> f = with_derivatives(function, x, y, in_first);
  const Real curvature = is_circular(function) ? Real(1) : abs(f.slope.slope);
  const Real& a = argument.bound;
  return abs(f.value.slope) * a + rounding.roundoff * curvature * a * a / Real(2);
}

/// The value of an exponential function so far out that 64 digits do not tell it from its limit;
/// the exponent of exp(1e300) would leave even CLN's range. Infinite limits are beyond the overflow
/// threshold.
std::optional<Real> limit_value(FunctionId function, const Real& x, const Rounding& rounding) {
  static const Real far(cln::cl_R(1 << 20));
  const std::optional<FarValues>& limits = function_row(function).far_values;
  if (!limits || !(far < abs(x))) return std::nullopt;
  const double limit = cln::plusp(x.value()) ? limits->right : limits->left;
  if (std::isfinite(limit)) return Real(static_cast<int>(limit));
  const Real infinite = rounding.largest * Real(32);
  return limit < 0 ? -infinite : infinite;
}

/// abs, min and max pass an operand on; sign is 1 in magnitude.
Bound kinked(FunctionId function, const Bound& x, const Bound& y) {
  const Real value = interpreter::call(function, x.value, y.value);
  if (function == FunctionId::sign) return leaf_bound(value, true);
  return inherit({value, max(x.bound, y.bound), false, false}, x, y);
}

}  // namespace

template <class Scalar>
const Rounding& rounding() {
  static const Rounding constants = rounding_of<Scalar>();
  return constants;
}
template const Rounding& rounding<float>();
template const Rounding& rounding<double>();

bool is_power_of_two(const Real& x) {
  if (!x.is_defined() || cln::zerop(x.value())) return false;
  return cln::abs(cln::decode_float(x.value()).mantissa) == cln::cl_RA(1) / 2;
}

Bound leaf_bound(const Real& value, bool exact) {
  return {value, abs(value), exact, false, exact ? 0U : 1U};
}

Bound leaf_bound(const cln::cl_R& value, const Rounding& rounding) {
  const Real number(value);
  const Real difference = number - rounding.nearest(value);
  return leaf_bound(number, difference.is_defined() && cln::zerop(difference.value()));
}

Bound BoundRules::negate(const Bound& x) const {
  return {-x.value, x.bound, x.exact, x.lost, x.roundings, x.underflows};
}

Bound BoundRules::add(const Bound& x, const Bound& y) const {
  Bound result = inherit(computed(x.value + y.value, x.bound + y.bound, rounding), x, y);
  ++result.roundings;
  return result;
}

Bound BoundRules::multiply(const Bound& x, const Bound& y) const {
  Bound result = inherit(computed(x.value * y.value, x.bound * y.bound, rounding), x, y);
  constexpr std::uint32_t most = 1'000'000;  // counts saturate: bounds are useless before
  result.roundings = std::min(x.roundings + y.roundings + 1, most);
  const bool scaled = x.exact && y.exact && (is_power_of_two(x.value) || is_power_of_two(y.value));
  result.exact = scaled && !(abs(result.value) < rounding.smallest);
  return result;
}

Bound BoundRules::divide(const Bound& x, const Bound& y) const {
  const Real value = x.value / y.value;
  const Real bound = (x.bound + abs(value) * y.bound) / abs(y.value);
  Bound result = inherit(computed(value, bound, rounding), x, y);
  ++result.roundings;
  result.lost = result.lost || !is_certain(y, rounding);
  return result;
}

Bound BoundRules::square_root(const Bound& x) const {
  const Real value = sqrt(x.value);
  if (!value.is_defined() || cln::zerop(value.value())) {
    return inherit({value, sqrt(x.bound), false, !x.exact}, x, x);
  }
  const Real slope = Real(1) / (value + value);
  const Real a = x.exact ? Real() : x.bound;
  const Real curvature = slope / (x.value + x.value);
  const Real bound = value + slope * a + rounding.roundoff * curvature * a * a / Real(2);
  Bound result = inherit(computed(value, bound, rounding), x, x);
  result.roundings = std::max(x.roundings, 1U);
  result.lost = result.lost || !is_certain(x, rounding);
  return result;
}

Bound RunningBoundRules::add(const Bound& x, const Bound& y) const {
  const Real value = x.value + y.value;
  return inherit_all(computed(value, x.bound + y.bound + abs(value), rounding), x, y);
}

Bound RunningBoundRules::multiply(const Bound& x, const Bound& y) const {
  const Real value = x.value * y.value;
  const Real of_operands = abs(x.value) * y.bound + abs(y.value) * x.bound;
  const Real bound = of_operands + rounding.roundoff * x.bound * y.bound + abs(value);
  return inherit_all(computed(value, bound, rounding), x, y);
}

Bound RunningBoundRules::divide(const Bound& x, const Bound& y) const {
  Bound result = BoundRules::divide(x, y);
  result.bound = result.bound + abs(result.value);
  result.roundings = 0;
  return result;
}

/// Those of one argument get as y what stands in a slot that they do not use.
Bound BoundRules::call(FunctionId function, const Bound& x, const Bound& slot) const {
  const bool is_binary = function_row(function).arity == 2;
  const Bound& y = is_binary ? slot : x;
  if (is_kinked(function)) return kinked(function, x, y);
  if (const auto limit = limit_value(function, x.value, rounding)) {
    return inherit(computed(*limit, abs(*limit), rounding), x, y);
  }
  const Real value = interpreter::call(function, x.value, y.value);
  Real bound = abs(value) + argument_part(function, x, y, true, rounding);
  if (is_binary) bound = bound + argument_part(function, x, y, false, rounding);
  Bound result = inherit(computed(value, bound, rounding), x, y);
  result.roundings = std::max(result.roundings, function_row(function).roundings);
  return result;
}

}  // namespace elgen
