// sampled_values: see sampled_values.hpp. There are two precautions. Nothing counts as 0 if 64
// digits hide a difference (1 - tanh(500), 1 + 1e-70 - 1). Errors in double are used only if they
// decide every comparison as errors in 64 digits would.
#include "forms/cancel/sampled_values.hpp"

#include <algorithm>
#include <cmath>

#include "accuracy/running_errors.hpp"

namespace elgen {
namespace {

/// A value is 0 if its running error is larger by this number of digits.
constexpr long vanished_digits = 40;
/// Digits are lost if one of two numbers is smaller by this number of digits.
constexpr long hidden_digits = 20;

using Number = RunningValue<Real>;
using Values = std::vector<Number>;

/// True if |x| <= share |y|.
bool is_below_share(const Real& x, const Real& y, const Real& share) {
  return abs(x).value() <= (abs(y) * share).value();
}

Number round_leaf(const cln::cl_RA& value) {
  return running_leaf(value, rounding_constants<double>());
}

/// True if 20 digits are lost: the smaller term of a sum disappears in the larger term, or a
/// function hardly depends on its argument, or depends on it so strongly that no digit is correct.
bool loses_digits(const Instruction& i, const Values& values, const Number& x) {
  static const Real hidden(power_of_ten(-hidden_digits));
  if (i.opcode == Opcode::add || i.opcode == Opcode::subtract) {
    const Number& a = values[i.a];
    const Number& b = values[i.b];
    if (is_zero(a.value) || is_zero(b.value)) return false;
    return is_below_share(a.value, b.value, hidden) || is_below_share(b.value, a.value, hidden);
  }
  const bool has_argument = i.opcode == Opcode::call && !is_zero(values[i.a].error);
  return has_argument && (is_below_share(x.error - abs(x.value), x.value, hidden) ||
                          is_below_share(x.value, x.error, hidden));
}

/// True if `noise`, the largest |x| that counts as 0, is at most 1e-20 of the largest operand.
bool has_small_noise(const Instruction& i, const Values& values, const Real& noise) {
  static const Real hidden(power_of_ten(-hidden_digits));
  Real terms = abs(values[i.a].value);
  if (operand_count(i) > 1) terms = max(terms, abs(values[i.b].value));
  return is_below_share(noise, terms, hidden);
}

/// x, the value of `i`, or exactly 0 if x vanishes. The result is marked as lost if 64 digits do
/// not decide whether x vanishes.
Number round_to_zero(const Instruction& i, const Values& values, Number x) {
  static const Real vanished(power_of_ten(-vanished_digits));
  if (!x.value.is_defined() || operand_count(i) == 0) return x;
  x.is_lost = x.is_lost || loses_digits(i, values, x);
  const bool vanishes = !x.is_lost && is_below_share(x.value, x.error, vanished) &&
                        has_small_noise(i, values, x.error * vanished);
  return vanishes ? Number{} : x;
}

SampledValue sampled_value(const Real& x, bool is_lost) {
  if (!x.is_defined()) return SampledValue::undefined;
  return is_zero(x) && !is_lost ? SampledValue::zero : SampledValue::nonzero;
}

/// A value rounded to double, and its running error in double.
using RoughValue = RunningValue<double>;
using RoughValues = std::vector<RoughValue>;

RoughValue round_roughly(const cln::cl_RA& value) {
  return running_leaf(value, rounding_constants<double, double>());
}

/// A running error in double is right within a factor of two, so comparisons of numbers that differ
/// by more than this factor are certain.
constexpr double certain_factor = 16;
constexpr double vanished_share = 1e-40;  ///< 10^-vanished_digits
constexpr double hidden_share = 1e-20;    ///< 10^-hidden_digits
/// If E - |f| is above this part of |f|, rounding in double does not hide it.
constexpr double visible_share = 1e-10;

/// True if products of three such numbers neither overflow nor underflow.
bool is_ordinary(double x) { return x == 0 || (std::abs(x) > 0x1p-300 && std::abs(x) < 0x1p300); }

/// True if x, the value of `i`, certainly loses no digits; see loses_digits().
bool keeps_digits(const Instruction& i, const RoughValues& values, const RoughValue& x) {
  if (x.is_lost) return false;
  constexpr double hidden = certain_factor * hidden_share;
  if (i.opcode == Opcode::add || i.opcode == Opcode::subtract) {
    const auto [least, most] =
        std::minmax({std::abs(values[i.a].value), std::abs(values[i.b].value)});
    return least == 0 || least > hidden * most;
  }
  const double size = std::abs(x.value);
  const bool has_argument = i.opcode == Opcode::call && values[i.a].error != 0;
  return !has_argument || (x.error - size > visible_share * size && size > hidden * x.error);
}

/// Whether x, the value of `i`, vanishes; none if errors in double do not decide this.
std::optional<bool> decide_vanishing(const Instruction& i, const RoughValues& values,
                                     const RoughValue& x) {
  if (!is_ordinary(x.value) || !is_ordinary(x.error)) return std::nullopt;
  if (operand_count(i) == 0) return false;
  if (!keeps_digits(i, values, x)) return std::nullopt;
  const double size = std::abs(x.value);
  const double noise = vanished_share * x.error;
  double terms = std::abs(values[i.a].value);
  if (operand_count(i) > 1) terms = std::max(terms, std::abs(values[i.b].value));
  const double visible = hidden_share * terms;
  if (size > certain_factor * noise || noise > certain_factor * visible) return false;
  const bool vanishes = certain_factor * size <= noise && certain_factor * noise <= visible;
  return vanishes ? std::optional(true) : std::nullopt;
}

/// True if a running error replaces this call by its limit, which NumberRules<Real> does not.
bool becomes_limit(const Instruction& i, const std::vector<Real>& values) {
  return i.opcode == Opcode::call &&
         is_replaced_by_limit(i.function, values[i.a], values[operand_count(i) > 1 ? i.b : i.a]);
}

/// The results of sample_values(); none if errors in double do not decide all of them.
std::optional<std::vector<SampledValue>> sample_with_rough_errors(const Program& program,
                                                                  const Function& function,
                                                                  const std::vector<bool>& needed,
                                                                  const RandomPoint& point) {
  const auto widen = [](const cln::cl_RA& x) { return Real(x); };
  const LeafValues<Real> leaves = map_leaves(widen, point.leaves);
  const interpreter::NumberRules<Real> numbers{leaves};
  const RunningErrorRules<double> errors{map_leaves(round_roughly, point.leaves)};
  std::vector<Real> values(needed.size(), Real());
  RoughValues rough(needed.size());
  std::vector<SampledValue> result(needed.size(), SampledValue::nonzero);
  for (std::size_t at = 0; at < needed.size(); ++at) {
    if (!needed[at]) continue;
    const Instruction& i = function.instructions[at];
    if (const std::optional<cln::cl_RA>& variable = point.variables[at]) {
      values[at] = widen(*variable);
      rough[at] = round_roughly(*variable);
      continue;
    }
    if (becomes_limit(i, values)) return std::nullopt;
    Real& x = values[at];
    x = fold_instruction(numbers, program, i, values);
    if (x.is_defined()) {
      rough[at] = fold_instruction(errors, program, i, rough);
      rough[at].value = cln::double_approx(x.value());
      const bool is_tiny = rough[at].value == 0 && !is_zero(x);
      const std::optional<bool> vanishes = decide_vanishing(i, rough, rough[at]);
      if (is_tiny || !vanishes) return std::nullopt;
      if (*vanishes) {
        x = Real();
        rough[at] = {};
      }
    }
    result[at] = sampled_value(x, false);
  }
  return result;
}

}  // namespace

std::vector<SampledValue> sample_in_64_digits(const Program& program, const Function& function,
                                              const std::vector<bool>& needed,
                                              const RandomPoint& point) {
  const RunningErrorRules<Real> rules{map_leaves(round_leaf, point.leaves)};
  Values values(needed.size(), Number{});
  std::vector<SampledValue> result(needed.size(), SampledValue::nonzero);
  for (std::size_t at = 0; at < needed.size(); ++at) {
    if (!needed[at]) continue;
    const Instruction& i = function.instructions[at];
    const std::optional<cln::cl_RA>& variable = point.variables[at];
    values[at] = variable ? round_leaf(*variable)
                          : round_to_zero(i, values, fold_instruction(rules, program, i, values));
    result[at] = sampled_value(values[at].value, values[at].is_lost);
  }
  return result;
}

std::vector<SampledValue> sample_values(const Program& program, const Function& function,
                                        const std::vector<bool>& needed, const RandomPoint& point) {
  auto rough = sample_with_rough_errors(program, function, needed, point);
  return rough ? *std::move(rough) : sample_in_64_digits(program, function, needed, point);
}

}  // namespace elgen
