#include "emit/code/angle_groups.hpp"

#include <algorithm>
#include <map>
#include <utility>

namespace elgen {
namespace {

bool calls_sine(const Instruction& instruction) {
  return instruction.opcode == Opcode::call && is_circular(instruction.function);
}

/// The nesting depth of sines in each instruction before the loop over columns.
std::vector<std::size_t> sine_depths(const Function& function) {
  std::vector<std::size_t> depths;
  for (std::size_t at = 0; at < first_repeated_instruction(function); ++at) {
    const Instruction& i = function.instructions[at];
    std::size_t depth = calls_sine(i) ? 1 : 0;
    if (operand_count(i) > 0) depth += depths[i.a];
    if (operand_count(i) > 1) depth = std::max(depth, depths[i.b]);
    depths.push_back(depth);
  }
  return depths;
}

/// Moves the calls of each angle to the first call of this angle.
AngleGroup join_calls_of_angles(const Function& function, const AngleGroup& calls) {
  std::map<std::uint32_t, std::uint32_t> first_calls;
  for (const std::uint32_t at : calls) first_calls.emplace(function.instructions[at].a, at);
  AngleGroup joined = calls;
  std::ranges::stable_sort(
      joined, {}, [&](std::uint32_t at) { return first_calls.at(function.instructions[at].a); });
  return joined;
}

}  // namespace

std::vector<AngleGroup> angle_groups(const Function& function) {
  const std::vector<std::size_t> depths = sine_depths(function);
  std::map<std::pair<std::size_t, bool>, AngleGroup> calls;
  for (std::uint32_t at = 0; at < depths.size(); ++at) {
    const Instruction& i = function.instructions[at];
    if (calls_sine(i)) calls[{depths[at], i.is_inner}].push_back(at);
  }
  std::vector<AngleGroup> groups;
  for (const auto& [key, group] : calls) {
    const std::uint32_t first = function.instructions[group.front()].a;
    const auto is_first = [&](std::uint32_t at) { return function.instructions[at].a == first; };
    if (!std::ranges::all_of(group, is_first))
      groups.push_back(join_calls_of_angles(function, group));
  }
  return groups;
}

bool has_angle_groups(const Program& program) {
  return std::ranges::any_of(program.functions,
                             [](const Function& f) { return !angle_groups(f).empty(); });
}

}  // namespace elgen
