// The rules of running errors.
#include "accuracy/running_errors.hpp"

namespace elgen {
namespace {

/// Magnitude of the derivative by one argument.
Real slope(FunctionId function, const Running& x, const Running& y, bool by_first) {
  const Dual<Real> first{x.value, Real(by_first ? 1 : 0)};
  const Dual<Real> second{y.value, Real(by_first ? 0 : 1)};
  return abs(interpreter::call(function, first, second).slope);
}

}  // namespace

std::vector<Real> values_of(const std::vector<Running>& all) {
  std::vector<Real> values;
  values.reserve(all.size());
  for (const Running& x : all) values.push_back(x.value);
  return values;
}

LeafValues<Running> running_leaves(const Arguments<double>& point, Leaves leaves) {
  const auto leaf = [leaves](double x) {
    const Real value(exact_value(x));
    return Running{value, leaves == Leaves::rounded ? abs(value) : Real()};
  };
  return map_leaves(leaf, point);
}

Running RunningErrorRules::constant(const Constant& constant) const {
  const Bound bound = leaf_bound(constant.value, rounding);
  return {bound.value, bound.exact ? Real() : abs(bound.value)};
}

Running RunningErrorRules::add(const Running& x, const Running& y) const {
  const Real value = x.value + y.value;
  return {value, x.error + y.error + abs(value)};
}

Running RunningErrorRules::multiply(const Running& x, const Running& y) const {
  const Real value = x.value * y.value;
  const bool is_scaled = is_power_of_two(x.value) || is_power_of_two(y.value);
  const Real own = is_scaled ? Real() : abs(value);
  return {value, x.error * abs(y.value) + y.error * abs(x.value) + own};
}

Running RunningErrorRules::divide(const Running& x, const Running& y) const {
  const Real value = x.value / y.value;
  return {value, (x.error + abs(value) * y.error) / abs(y.value) + abs(value)};
}

Running RunningErrorRules::square_root(const Running& x) const {
  const Real value = sqrt(x.value);
  return {value, x.error / (value + value) + value};
}

/// Kinked functions pass an operand on. Those of one argument ignore y.
Running RunningErrorRules::call(FunctionId function, const Running& x, const Running& y) const {
  const FunctionRow& row = function_row(function);
  const Real value = interpreter::call(function, x.value, y.value);
  const Running& second = row.arity == 2 ? y : x;
  if (is_kinked(function)) return {value, max(x.error, second.error)};
  Real error = abs(value) + slope(function, x, y, true) * x.error;
  if (row.arity == 2) error = error + slope(function, x, y, false) * y.error;
  return {value, error};
}

}  // namespace elgen
