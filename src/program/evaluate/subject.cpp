// Conversions of states: binary arguments to exact rationals, and states to text.
#include "program/evaluate/subject.hpp"

#include <cln/dfloat.h>
#include <cln/ffloat.h>
#include <cln/float.h>
#include <cln/integer.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "sample/states.hpp"

namespace elgen {
namespace {

using cln::cl_R;

/// `value` in six digits; if `exactly`, in the 17 digits that identify a double.
std::string number_text(const cl_R& value, bool exactly) {
  if (!exactly) return short_number_text(value);
  return fmt::format("{:.17g}", to_double(value));
}

std::string list_text(std::string_view name, const std::vector<cl_R>& values, bool exactly) {
  if (values.empty()) return {};
  std::string text = fmt::format("{} = (", name);
  const std::size_t shown = exactly ? values.size() : std::min<std::size_t>(values.size(), 8);
  for (std::size_t i = 0; i < shown; ++i) {
    text += (i == 0 ? "" : ", ") + number_text(values[i], exactly);
  }
  return text + (shown < values.size() ? ", …)" : ")");
}

std::string changed_parameters_text(const SystemUnderTest& subject, const State& state,
                                    bool exactly) {
  const std::vector<double> nominal =
      arguments_at<double>(nominal_state(subject.model, subject.scene)).parameters;
  const std::vector<double> actual = arguments_at<double>(state).parameters;
  std::string text;
  for (std::size_t i = 0; i < actual.size(); ++i) {
    const double scale = std::max(std::abs(nominal[i]), std::abs(actual[i]));
    // Rounding a nominal value to float does not count as a change.
    if (std::abs(actual[i] - nominal[i]) <= 1e-6 * scale) continue;
    text += fmt::format("{}{} = {}", text.empty() ? "" : ", ", subject.model.parameters[i].name,
                        number_text(state.parameters[i], exactly));
  }
  return text;
}

std::string state_description(const SystemUnderTest& subject, const State& state, bool exactly) {
  std::vector<std::string> parts;
  const auto add = [&parts](std::string part) {
    if (!part.empty()) parts.push_back(std::move(part));
  };
  for_each_list(
      [&](const LeafRow& row, const std::vector<cl_R>& values) {
        const bool is_shown =
            row.id != Opcode::parameter && may_be_argument(subject.program.leaves, row.id);
        if (is_shown) add(list_text(row.symbol, values, exactly));
      },
      state);
  if (subject.model.uses_time) add("t = " + number_text(state.t, exactly));
  if (!subject.program.leaves.h.empty()) add("h = " + number_text(state.h, exactly));
  add(changed_parameters_text(subject, state, exactly));
  return fmt::format("{}", fmt::join(parts, ", "));
}

}  // namespace

template <class Scalar>
State exact_state(const SystemUnderTest& subject, const Arguments<Scalar>& arguments) {
  State state = map_leaves(
      [](Scalar value) -> cl_R { return exact_value(static_cast<double>(value)); }, arguments);
  const State nominal = nominal_state(subject.model, subject.scene);
  for (const auto& fixed : subject.scene.specialisation.fixed) {
    state.parameters[fixed.first] = nominal.parameters[fixed.first];
  }
  // Quaternions have length 1 only up to rounding. If the length is not 1, the two sides of a
  // comparison may legitimately differ. After scaling, which changes the arguments by a few
  // roundings, the two sides must agree.
  normalize_state_quaternions(subject.model, state);
  return state;
}

template State exact_state(const SystemUnderTest&, const Arguments<double>&);
template State exact_state(const SystemUnderTest&, const Arguments<float>&);

OracleValues to_oracle_values(const std::vector<Real>& values) {
  std::vector<cl_R> numbers;
  for (const Real& value : values) {
    if (!value.is_defined()) return std::nullopt;
    numbers.push_back(value.value());
  }
  return numbers;
}

const Function* find_function(const Program& program, OutputKind kind, std::uint32_t user) {
  const auto found =
      std::find_if(program.functions.begin(), program.functions.end(),
                   [&](const Function& f) { return f.kind == kind && f.user == user; });
  return found == program.functions.end() ? nullptr : &*found;
}

std::vector<Real> stabilising_terms(const Model& model, const State& state,
                                    const std::vector<Real>& residual) {
  const auto gain = [&](const std::optional<ExpressionId>& expression) {
    if (!expression) return Real();
    const std::optional<cl_R> value = oracle_expression_value(model, *expression, state);
    return value ? Real(*value) : Real::undefined();
  };
  std::size_t position = 0;
  std::size_t rate = residual.size() - model.constraints.size();
  std::vector<Real> terms;
  for (const Constraint& constraint : model.constraints) {
    const Real omega = gain(constraint.omega);
    Real& term = terms.emplace_back(Real(2) * gain(constraint.zeta) * omega * residual[rate++]);
    if (constraint.is_position) term = term + omega * omega * residual[position++];
  }
  return terms;
}

std::string describe_state(const SystemUnderTest& subject, const State& state) {
  return state_description(subject, state, false);
}

std::string describe_state_exactly(const SystemUnderTest& subject, const State& state) {
  return state_description(subject, state, true);
}

std::string short_number_text(const cl_R& value) {
  if (cln::zerop(value)) return "0";
  const cln::cl_F number = cln::cl_float(value, cln::float_format(20));
  const double rounded = to_double(value);
  if (std::isfinite(rounded) && std::abs(rounded) > std::numeric_limits<double>::min()) {
    return fmt::format("{:.6g}", rounded);
  }
  // Beyond double: divide by a power of ten, found from the binary exponent.
  const long decimal = std::lround(std::floor(decimal_exponent(number)));
  const cl_R scaled = number / cln::expt(cln::cl_float(10, number), cln::cl_I(decimal));
  return fmt::format("{:.3g}e{}", to_double(scaled), decimal);
}

}  // namespace elgen
