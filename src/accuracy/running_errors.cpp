// running_errors: the rules of running_errors.hpp.
#include "accuracy/running_errors.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <type_traits>

namespace elgen {
namespace {

using std::abs;
using std::max;
using std::sqrt;

/// The largest relative error of an operand for which the first-order error of a result is correct
/// within a few parts in 1000.
constexpr double max_relative_error = 0x1p-10;

bool is_number(const Real& x) { return x.is_defined(); }
bool is_number(double x) { return std::isfinite(x); }

bool is_zero(double x) { return x == 0; }

template <class Number>
Number to_number(double x) {
  if constexpr (std::is_same_v<Number, double>) {
    return x;
  } else {
    return Number(exact_value(x));
  }
}

template <class Scalar, class Number>
RoundingConstants<Number> make_rounding() {
  using Limits = std::numeric_limits<Scalar>;
  const double u = double{Limits::epsilon()} / 2;
  return {to_number<Number>(u), to_number<Number>(Limits::denorm_min()) / to_number<Number>(u),
          to_number<Number>(Limits::min()),
          to_number<Number>(Limits::max()) / to_number<Number>(16), [](const cln::cl_R& value) {
            const auto nearest = ScalarTraits<Scalar>::from_real(value);
            return std::isfinite(nearest) && exact_value(double{nearest}) == value;
          }};
}

/// The result of an operation on x and y, with `value` and `error`. Adds the error of underflow to
/// `error`. Takes over is_lost and underflows from x and y.
template <class Number>
RunningValue<Number> finish_operation(const Number& value, const Number& error,
                                      const RunningValue<Number>& x, const RunningValue<Number>& y,
                                      const RoundingConstants<Number>& rounding) {
  RunningValue<Number> result{value, error, x.is_lost || y.is_lost, x.underflows || y.underflows};
  if (value < rounding.smallest && -value < rounding.smallest && !is_zero(value)) {
    result.error = result.error + rounding.underflow;
    result.underflows = true;
  }
  result.is_lost = result.is_lost || !is_number(result.error);
  return result;
}

/// True if multiplying by x is exact: x is a power of two without an error. A rounded value may be
/// a power of two by chance.
template <class Number>
bool is_exact_factor(const RunningValue<Number>& x) {
  return is_zero(x.error) && is_power_of_two(x.value);
}

/// True if the sum `value` of x and y is exact: both have no errors and |x + y| <= min(|x|, |y|)
/// (Sterbenz 1974). If x or y is rounded, the computed operands may violate this condition.
template <class Number>
bool is_exact_difference(const RunningValue<Number>& x, const RunningValue<Number>& y,
                         const Number& value) {
  const Number difference = abs(value);
  return is_zero(x.error) && is_zero(y.error) && difference <= abs(x.value) &&
         difference <= abs(y.value);
}

/// True if the error of x is small compared with `scale`.
template <class Number>
bool is_accurate(const RunningValue<Number>& x, const Number& scale,
                 const RoundingConstants<Number>& rounding) {
  static const auto share = to_number<Number>(max_relative_error);
  return x.error * rounding.roundoff <= scale * share;
}

/// True if the first-order error of f(x) is accurate. Always true for sine and cosine; otherwise
/// the error of x must be small compared with |x|, or with max(|x|, 1) for entire functions.
template <class Number>
bool is_accurate_argument(const FunctionRow& row, const RunningValue<Number>& x,
                          const RoundingConstants<Number>& rounding) {
  if (is_circular(row.id)) return true;
  const bool is_entire =
      row.smoothness == Smoothness::entire || row.smoothness == Smoothness::entire_positive;
  return is_accurate(x, is_entire ? max(abs(x.value), Number(1)) : abs(x.value), rounding);
}

bool is_beyond_limit(const FunctionRow& row, const Real& x) {
  static const Real far(cln::cl_R(1 << 20));
  return row.limits_at_infinity && far < abs(x);
}

/// The limit that replaces the value of an exponential function, see is_replaced_by_limit(); none
/// if the value is computed. exp(1e300), for example, exceeds even the exponents of CLN. An
/// infinite limit becomes a number beyond the overflow threshold of the scalar.
std::optional<Real> limit_value(const FunctionRow& row, const Real& x,
                                const RoundingConstants<Real>& rounding) {
  if (!is_beyond_limit(row, x)) return std::nullopt;
  const double limit =
      cln::plusp(x.value()) ? row.limits_at_infinity->right : row.limits_at_infinity->left;
  if (std::isfinite(limit)) return Real(static_cast<int>(limit));
  const Real infinite = rounding.largest * Real(32);
  return limit < 0 ? -infinite : infinite;
}
std::optional<double> limit_value(const FunctionRow& /*row*/, double /*x*/,
                                  const RoundingConstants<double>& /*rounding*/) {
  return std::nullopt;
}

/// f(x, y) and its derivative by x if `by_first`, else by y.
template <class Number>
Dual<Number> call_with_derivative(FunctionId function, const Number& x, const Number& y,
                                  bool by_first) {
  const Dual<Number> first{x, Number(by_first ? 1 : 0)};
  const Dual<Number> second{y, Number(by_first ? 0 : 1)};
  return interpreter::call(function, first, second);
}

}  // namespace

bool is_replaced_by_limit(FunctionId function, const Real& x, const Real& y) {
  return is_beyond_limit(function_row(growth_function(function, y < Real())), x);
}

bool is_power_of_two(const Real& x) {
  if (!x.is_defined() || is_zero(x)) return false;
  return cln::abs(cln::decode_float(x.value()).mantissa) == cln::cl_RA(1) / 2;
}
bool is_power_of_two(double x) {
  int exponent = 0;
  return std::abs(std::frexp(x, &exponent)) == 0.5;
}

template <class Scalar, class Number>
const RoundingConstants<Number>& rounding_constants() {
  static const RoundingConstants<Number> constants = make_rounding<Scalar, Number>();
  return constants;
}
template const RoundingConstants<Real>& rounding_constants<float, Real>();
template const RoundingConstants<Real>& rounding_constants<double, Real>();
template const RoundingConstants<double>& rounding_constants<double, double>();

template <class Number>
RunningValue<Number> running_leaf(const cln::cl_R& value,
                                  const RoundingConstants<Number>& rounding) {
  const auto x = ScalarTraits<Number>::from_real(value);
  return {x, rounding.is_exact(value) ? Number{} : abs(x)};
}
template RunningValue<Real> running_leaf(const cln::cl_R&, const RoundingConstants<Real>&);
template RunningValue<double> running_leaf(const cln::cl_R&, const RoundingConstants<double>&);

template <class Number>
LeafValues<RunningValue<Number>> running_leaves(const Arguments<double>& point,
                                                LeafRounding leaves) {
  const auto leaf = [leaves](double x) {
    const auto value = to_number<Number>(x);
    return RunningValue<Number>{value, leaves == LeafRounding::rounded ? abs(value) : Number{}};
  };
  return map_leaves(leaf, point);
}
template LeafValues<RunningValue<Real>> running_leaves(const Arguments<double>&, LeafRounding);
template LeafValues<RunningValue<double>> running_leaves(const Arguments<double>&, LeafRounding);

template <class Number>
auto RunningErrorRules<Number>::add(const Value& x, const Value& y) const -> Value {
  const Number value = x.value + y.value;
  const Number own = is_exact_difference(x, y, value) ? Number{} : abs(value);
  return finish_operation<Number>(value, x.error + y.error + own, x, y, rounding);
}

template <class Number>
auto RunningErrorRules<Number>::multiply(const Value& x, const Value& y) const -> Value {
  const Number value = x.value * y.value;
  const bool is_scaled = is_exact_factor(x) || is_exact_factor(y);
  const Number own = is_scaled ? Number{} : abs(value);
  const Number farthest = abs(y.value) + rounding.roundoff * y.error;
  return finish_operation<Number>(value, x.error * farthest + y.error * abs(x.value) + own, x, y,
                                  rounding);
}

template <class Number>
auto RunningErrorRules<Number>::divide(const Value& x, const Value& y) const -> Value {
  const Number value = x.value / y.value;
  const Number error = (x.error + abs(value) * y.error) / abs(y.value) + abs(value);
  Value result = finish_operation<Number>(value, error, x, y, rounding);
  result.is_lost = result.is_lost || !is_accurate(y, abs(y.value), rounding);
  return result;
}

template <class Number>
auto RunningErrorRules<Number>::square_root(const Value& x) const -> Value {
  const Number value = sqrt(x.value);
  const Number slope = is_zero(x.error) ? Number{} : x.error / (value + value);
  Value result = finish_operation<Number>(value, slope + value, x, x, rounding);
  result.is_lost = result.is_lost || !is_accurate(x, abs(x.value), rounding);
  return result;
}

template <class Number>
auto RunningErrorRules<Number>::call(FunctionId function, const Value& x, const Value& y) const
    -> Value {
  const FunctionRow& row = function_row(function);
  const bool is_binary = row.arity == 2;
  const Value& second = is_binary ? y : x;
  if (is_kinked(function)) {
    Value result = finish_operation<Number>(interpreter::call(function, x.value, y.value),
                                            max(x.error, second.error), x, second, rounding);
    const bool jumps = function == FunctionId::sign;
    result.is_lost = result.is_lost || (jumps && !is_accurate(x, abs(x.value), rounding));
    return result;
  }
  const FunctionRow& far = function_row(growth_function(function, second.value < Number{}));
  if (const auto limit = limit_value(far, x.value, rounding)) {
    return finish_operation<Number>(*limit, abs(*limit), x, second, rounding);
  }
  const Dual<Number> f = call_with_derivative(function, x.value, y.value, true);
  Number error = abs(f.value);
  if (!is_zero(x.error)) error = error + abs(f.slope) * x.error;
  if (is_circular(function)) {
    error = error + rounding.roundoff * x.error * x.error / Number(2);
  }
  if (is_binary && !is_zero(y.error)) {
    error = error + abs(call_with_derivative(function, x.value, y.value, false).slope) * y.error;
  }
  Value result = finish_operation<Number>(f.value, error, x, second, rounding);
  result.is_lost = result.is_lost || !is_accurate_argument(row, x, rounding) ||
                   !is_accurate_argument(row, second, rounding);
  return result;
}

template struct RunningErrorRules<Real>;
template struct RunningErrorRules<double>;

}  // namespace elgen
