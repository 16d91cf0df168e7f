// An analytic function that is 0 at random points is 0. There are three precautions. Values that
// are not analytic become independent variables (program/network/analytic.hpp). Nothing is
// concluded if 64 digits hide a difference (1 - tanh(500), 1 + 1e-70 - 1). A point says nothing
// about the operands of a value that is undefined at this point.
#include "forms/cancel/vanishing.hpp"

#include <algorithm>

#include "accuracy/running_errors.hpp"
#include "program/network/analytic.hpp"
#include "sample/points.hpp"

namespace elgen {
namespace {

using Number = RunningValue<Real>;
using Values = std::vector<Number>;

constexpr std::uint64_t first_seed = 1;
constexpr std::uint64_t other_seed = 2;

/// True if |x| <= share |y|.
bool is_below_share(const Real& x, const Real& y, const Real& share) {
  return abs(x).value() <= (abs(y) * share).value();
}

Number round_leaf(const cln::cl_RA& value) {
  return running_leaf(value, rounding_constants<double>());
}

/// For each instruction: true for a call of a function with kinks. The call may be 0 in a whole
/// region. A random number replaces the value of the call. Roots are not marked, but computed.
std::vector<bool> mark_kinked_calls(const Function& function) {
  std::vector<bool> result;
  for (const Instruction& i : function.instructions) {
    result.push_back(i.opcode == Opcode::call && is_kinked(i.function));
  }
  return result;
}

/// True if 20 digits are lost: the smaller term of a sum disappears in the larger term, or a
/// function hardly depends on its argument, or depends on it so strongly that no digit is correct.
bool loses_digits(const Instruction& i, const Values& values, const Number& x) {
  static const Real hidden(power_of_ten(-20));
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
  static const Real hidden(power_of_ten(-20));
  Real terms = abs(values[i.a].value);
  if (operand_count(i) > 1) terms = max(terms, abs(values[i.b].value));
  return is_below_share(noise, terms, hidden);
}

/// x, the value of `i`, or exactly 0 if x vanishes. The result is marked as lost if 64 digits do
/// not decide whether x vanishes.
Number round_to_zero(const Instruction& i, const Values& values, Number x) {
  static const Real vanished(power_of_ten(-40));
  if (!x.value.is_defined() || operand_count(i) == 0) return x;
  x.is_lost = x.is_lost || loses_digits(i, values, x);
  const bool vanishes = !x.is_lost && is_below_share(x.value, x.error, vanished) &&
                        has_small_noise(i, values, x.error * vanished);
  return vanishes ? Number{} : x;
}

/// Evaluates the `needed` instructions at the next random point. Instructions in `variables` get
/// random values.
Values evaluate_at_random_point(const Program& program, const Function& function,
                                const std::vector<bool>& needed, const std::vector<bool>& variables,
                                Sampler& draw) {
  const LeafValues<Number> point = map_leaves(round_leaf, draw.point(program.leaves));
  const RunningErrorRules<Real> rules{point};
  Values values(function.instructions.size(), Number{});
  for (std::size_t at = 0; at < values.size(); ++at) {
    if (!needed[at]) continue;
    const Instruction& i = function.instructions[at];
    values[at] = variables[at]
                     ? round_leaf(cln::abs(draw.number()))
                     : round_to_zero(i, values, fold_instruction(rules, program, i, values));
  }
  return values;
}

/// For each instruction: true if an undefined value depends on it.
std::vector<bool> mark_undefined_operands(const Function& function, const Values& values,
                                          const std::vector<bool>& needed) {
  std::vector<std::uint32_t> undefined;
  for (std::uint32_t at = 0; at < values.size(); ++at) {
    if (needed[at] && !values[at].value.is_defined()) undefined.push_back(at);
  }
  return needed_instructions(function, undefined);
}

/// The `candidates` that also vanish at the next random point.
std::vector<std::uint32_t> keep_vanishing(const Program& program, const Function& function,
                                          const std::vector<std::uint32_t>& candidates,
                                          const std::vector<bool>& variables, Sampler& draw) {
  const std::vector<bool> needed = needed_instructions(function, candidates);
  const Values values = evaluate_at_random_point(program, function, needed, variables, draw);
  const std::vector<bool> excluded = mark_undefined_operands(function, values, needed);
  std::vector<std::uint32_t> result;
  for (const std::uint32_t at : candidates) {
    const bool vanishes = is_zero(values[at].value) && !values[at].is_lost;
    if (vanishes && !excluded[at]) result.push_back(at);
  }
  return result;
}

}  // namespace

std::vector<std::uint32_t> find_vanishing_values(const Program& program, const Function& function) {
  std::vector<std::uint32_t> operations;
  for (std::uint32_t at = 0; at < function.instructions.size(); ++at) {
    if (operand_count(function.instructions[at]) > 0) operations.push_back(at);
  }
  Sampler draw(first_seed);
  return keep_vanishing(program, function, operations, mark_kinked_calls(function), draw);
}

std::vector<bool> find_vanishing_entries(const Program& program, const Function& function) {
  const std::vector<std::uint32_t> entries = entries_of(function);
  const std::vector<bool> variables = mark_unknown_values(program, function);
  std::vector<std::uint32_t> left = entries;
  Sampler draw(other_seed);
  for (std::size_t i = 1; i < zero_sample_count && !left.empty(); ++i) {
    left = keep_vanishing(program, function, left, variables, draw);
  }
  std::vector<bool> result;
  for (const std::uint32_t at : entries) {
    result.push_back(std::find(left.begin(), left.end(), at) != left.end());
  }
  return result;
}

}  // namespace elgen
