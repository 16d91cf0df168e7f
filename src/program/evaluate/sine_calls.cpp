#include "program/evaluate/sine_calls.hpp"

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

/// Parts of at most `most_angles_together` angles.
std::vector<AngleGroup> cut_group(const Function& function, const AngleGroup& group) {
  std::vector<AngleGroup> parts;
  std::size_t angles = 0;
  for (std::size_t i = 0; i < group.size(); ++i) {
    const bool is_new =
        i == 0 || function.instructions[group[i]].a != function.instructions[group[i - 1]].a;
    if (is_new && angles++ % most_angles_together == 0) parts.emplace_back();
    parts.back().push_back(group[i]);
  }
  return parts;
}

bool has_several_angles(const Function& function, const AngleGroup& group) {
  const std::uint32_t first = function.instructions[group.front()].a;
  return std::ranges::any_of(
      group, [&](std::uint32_t at) { return function.instructions[at].a != first; });
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
    for (AngleGroup& part : cut_group(function, join_calls_of_angles(function, group)))
      if (has_several_angles(function, part)) groups.push_back(std::move(part));
  }
  return groups;
}

bool has_angle_groups(const Program& program) {
  return std::ranges::any_of(program.functions,
                             [](const Function& f) { return !angle_groups(f).empty(); });
}

bool starts_sine_cosine_pair(const Function& function, std::size_t at) {
  if (at + 1 >= function.instructions.size()) return false;
  const Instruction& sine = function.instructions[at];
  Instruction cosine = sine;
  cosine.function = FunctionId::cos;
  return sine.opcode == Opcode::call && sine.function == FunctionId::sin &&
         function.instructions[at + 1] == cosine;
}

SineCosinePairing in_line_pairing(const Scene& scene) {
  const bool is_grouped = language_row(scene.emission.language).groups_angles;
  return is_grouped ? SineCosinePairing::grouped : SineCosinePairing::joint;
}

std::vector<bool> lone_sine_calls(const Function& function, SineCosinePairing pairing) {
  std::vector<bool> is_lone(function.instructions.size());
  for (std::size_t at = 0; at < is_lone.size(); ++at) {
    is_lone[at] = calls_sine(function.instructions[at]);
    const bool is_second = at > 0 && starts_sine_cosine_pair(function, at - 1);
    if (pairing != SineCosinePairing::separate && is_second) is_lone[at - 1] = is_lone[at] = false;
  }
  if (pairing == SineCosinePairing::grouped) {
    for (const AngleGroup& group : angle_groups(function)) {
      for (const std::uint32_t at : group) is_lone[at] = false;
    }
  }
  if (std::ranges::count(is_lone, true) == 0) is_lone.clear();
  return is_lone;
}

bool has_lone_sine_calls(const Program& program, SineCosinePairing pairing) {
  return std::ranges::any_of(program.functions, [pairing](const Function& function) {
    return !lone_sine_calls(function, pairing).empty();
  });
}

}  // namespace elgen
