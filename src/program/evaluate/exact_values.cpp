// Values and derivatives of a program at one state, in 64 digits.
#include "program/evaluate/exact_values.hpp"

#include "elgen/outputs.hpp"
#include "model/requests.hpp"

namespace elgen {
namespace {

std::vector<Real> oracle_entries(const SystemUnderTest& subject, const State& state,
                                 OutputKind kind, std::uint32_t user) {
  const OutputRequest request = make_request(subject.model, kind, user);
  const OracleValues exact = oracle_values(subject.model, request, state);
  const std::size_t entries = std::size_t{request.rows} * request.columns;
  if (!exact) return std::vector<Real>(entries, Real::undefined());
  std::vector<Real> values;
  for (const cln::cl_R& value : *exact) values.emplace_back(value);
  return values;
}

/// max |x| over `values`; undefined if any value is undefined.
Real largest_magnitude(const std::vector<Real>& values) {
  Real largest;
  for (const Real& value : values) largest = max(largest, abs(value));
  return largest;
}

}  // namespace

ExactValues::ExactValues(const SystemUnderTest& subject, State state)
    : subject_(subject), state_(std::move(state)), arguments_(arguments_at<Real>(state_)) {
  Real largest;
  for (const Function& function : subject_.program.functions) {
    const std::vector<Real> values = evaluate_instructions(subject_.program, function, arguments_);
    const Real here = largest_magnitude(values);
    // Functions that are undefined at this state do not contribute, so that the floor stays
    // defined. Only the verification rows of an undefined function fail or are skipped.
    if (here.is_defined()) largest = max(largest, here);
    values_[{function.kind, function.user}] = entries_of(function, values);
  }
  rounding_floor_ = largest * Real(power_of_ten(-20));
}

const std::vector<Real>& ExactValues::entries(OutputKind kind, std::uint32_t user) {
  const auto key = std::make_pair(kind, user);
  const auto known = values_.find(key);
  if (known != values_.end()) return known->second;
  return values_[key] = oracle_entries(subject_, state_, kind, user);
}

std::vector<Real> ExactValues::entries_at(OutputKind kind, const Arguments<Real>& arguments) const {
  return evaluate(subject_.program, *find_function(subject_.program, kind), arguments);
}

std::vector<Real> ExactValues::directional_derivatives(OutputKind kind,
                                                       const Arguments<Real>& direction,
                                                       std::uint32_t user) const {
  const Function& function = *find_function(subject_.program, kind, user);
  std::vector<Real> result;
  for (const Dual<Real>& entry : evaluate(
           subject_.program, function, dual_leaves(arguments_, add_open_value_rates(direction)))) {
    result.push_back(entry.slope);
  }
  return result;
}

/// `direction`, with the tangents of the values of functions without expression:
/// df = sum_i f_i dx_i, f_i = df/dx_i.
Arguments<Real> ExactValues::add_open_value_rates(Arguments<Real> direction) const {
  const Model& model = subject_.model;
  if (model.functions.empty()) return direction;
  const State along = map_leaves([](const Real& x) -> cln::cl_R { return x.value(); }, direction);
  // Memoised: functions and their derivatives share arguments, and slopes of arguments cost most.
  std::map<std::uint32_t, Real> found;
  const auto slope_of = [&](std::uint32_t argument) {
    const auto known = found.find(argument);
    if (known != found.end()) return known->second;
    const auto slope = oracle_directional_derivative(model, argument, state_, along);
    return found[argument] = slope ? Real(*slope) : Real::undefined();
  };
  for (std::uint32_t i = 0; i < direction.f.size(); ++i) {
    const OpenFunction& function = model.functions[model.open_values[i].function];
    Real rate;
    for (std::uint32_t k = 0; k < function.arguments.size(); ++k) {
      const auto derivative = find_open_derivative(model, i, k);
      if (!derivative) continue;
      rate = rate + arguments_.f[*derivative] * slope_of(function.arguments[k]);
    }
    direction.f[i] = rate;
  }
  return direction;
}

std::vector<Real> ExactValues::second_derivatives(OutputKind kind, const Arguments<Real>& direction,
                                                  std::uint32_t user) const {
  const Function& function = *find_function(subject_.program, kind, user);
  const auto once = dual_leaves(arguments_, direction);
  const auto twice = dual_leaves(once, dual_leaves(direction, zero_direction()));
  std::vector<Real> result;
  for (const Dual<Dual<Real>>& entry : evaluate(subject_.program, function, twice)) {
    result.push_back(entry.slope.slope);
  }
  return result;
}

std::vector<Real> ExactValues::coordinate_rates(const std::vector<Real>& v) const {
  State state = state_;
  for (std::size_t i = 0; i < v.size(); ++i) state.v[i] = v[i].value();
  return oracle_entries(subject_, state, OutputKind::coordinate_rates, 0);
}

std::vector<Real> ExactValues::coasting_accelerations() const {
  const Model& model = subject_.model;
  if (model.rotations.empty()) return std::vector<Real>(state_.q.size());
  State state = state_;
  const std::vector<Real> rates = coordinate_rates(arguments_.v);
  for (std::size_t i = 0; i < rates.size(); ++i) state.q[i] = rates[i].value();
  std::vector<Real> result = oracle_entries(subject_, state, OutputKind::coordinate_rates, 0);
  for (std::size_t i = 0; i < result.size(); ++i) {
    if (!model.coordinates[i].rotation) result[i] = Real();
  }
  return result;
}

Arguments<Real> ExactValues::zero_direction() const {
  return map_leaves([](const Real&) { return Real(); }, arguments_);
}

std::optional<double> ResidualSums::relative_residual(const Real& floor) const {
  const Real difference = largest_magnitude(sums_);
  const Real scale = largest_magnitude(sizes_) + floor;
  if (!difference.is_defined() || !scale.is_defined()) return std::nullopt;
  if (cln::zerop(difference.value())) return 0.0;
  const Real quotient = difference / scale;
  if (!quotient.is_defined()) return std::nullopt;
  return to_double(quotient.value());
}

}  // namespace elgen
