// An analytic function that is 0 at random points is 0. There are two precautions. Values that are
// not analytic become independent variables (program/network/analytic.hpp). A point says nothing
// about the operands of a value that is undefined at this point.
#include "forms/cancel/vanishing.hpp"

#include <algorithm>

#include "forms/cancel/sampled_values.hpp"
#include "program/network/analytic.hpp"
#include "sample/points.hpp"

namespace elgen {
namespace {

constexpr std::uint64_t first_seed = 1;
constexpr std::uint64_t other_seed = 2;

/// For each instruction: true for a call of a function with kinks. The call may be 0 in a whole
/// region. A random number replaces the value of the call. Roots are not marked, but computed.
std::vector<bool> mark_kinked_calls(const Function& function) {
  std::vector<bool> result;
  for (const Instruction& i : function.instructions) {
    result.push_back(i.opcode == Opcode::call && is_kinked(i.function));
  }
  return result;
}

/// The next random point. Instructions that are `needed` and in `variables` get random values.
RandomPoint draw_point(const Program& program, const std::vector<bool>& needed,
                       const std::vector<bool>& variables, Sampler& draw) {
  RandomPoint point{draw.point(program.leaves)};
  point.variables.resize(needed.size());
  for (std::size_t at = 0; at < needed.size(); ++at) {
    if (needed[at] && variables[at]) point.variables[at] = cln::abs(draw.number());
  }
  return point;
}

/// For each instruction: true if an undefined value depends on it.
std::vector<bool> mark_undefined_operands(const Function& function,
                                          const std::vector<SampledValue>& values) {
  std::vector<std::uint32_t> undefined;
  for (std::uint32_t at = 0; at < values.size(); ++at) {
    if (values[at] == SampledValue::undefined) undefined.push_back(at);
  }
  return needed_instructions(function, undefined);
}

/// The `candidates` that also vanish at the next random point.
std::vector<std::uint32_t> keep_vanishing(const Program& program, const Function& function,
                                          const std::vector<std::uint32_t>& candidates,
                                          const std::vector<bool>& variables, Sampler& draw) {
  const std::vector<bool> needed = needed_instructions(function, candidates);
  const RandomPoint point = draw_point(program, needed, variables, draw);
  const std::vector<SampledValue> values = sample_values(program, function, needed, point);
  const std::vector<bool> excluded = mark_undefined_operands(function, values);
  std::vector<std::uint32_t> result;
  for (const std::uint32_t at : candidates) {
    if (values[at] == SampledValue::zero && !excluded[at]) result.push_back(at);
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
