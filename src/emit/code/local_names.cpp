// local_names: adapts the names of the program to the language. A name that would hide another name
// gets an underscore, a long name is cut, and new names split a deep formula. Sines and cosines
// that are computed together have names.
#include "emit/code/local_names.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <string_view>
#include <utility>

#include "elgen/leaf_names.hpp"
#include "program/evaluate/sine_calls.hpp"

namespace elgen {
namespace {

/// A name that is too long keeps this many characters, followed by "_" and a number.
constexpr std::size_t truncated_name_length = 40;

/// The limit of nested brackets, and the names in use.
struct NamingLimits {
  std::size_t max_bracket_depth = 0;
  std::set<std::string> used_names = {};
};

/// Names the values whose formulas would nest more brackets than the language can parse. Each
/// instruction that is written out adds at most two levels.
void name_deep_values(const Function& function, NamingLimits bounds,
                      std::vector<std::string>& names) {
  std::vector<std::size_t> depths(names.size(), 0);
  std::size_t count = 0;
  for (std::size_t at = 0; at < names.size(); ++at) {
    const Instruction& i = function.instructions[at];
    const std::size_t operands = operand_count(i);
    if (operands == 0) continue;
    const auto depth = [&](std::uint32_t of) { return names[of].empty() ? depths[of] : 0; };
    depths[at] = 2 + std::max(depth(i.a), operands > 1 ? depth(i.b) : 0);
    if (depths[at] <= bounds.max_bracket_depth || !names[at].empty()) continue;
    do names[at] = fmt::format("inner_{}", ++count);
    while (!bounds.used_names.insert(names[at]).second);
  }
}

/// "sin_1", "cos_2": names the calls of groups that have no name.
void name_grouped_calls(const Function& function, std::set<std::string>& used,
                        std::vector<std::string>& names) {
  for (const AngleGroup& group : angle_groups(function)) {
    for (const std::uint32_t at : group) {
      const std::string_view name = function_row(function.instructions[at].function).name;
      for (std::size_t number = 1; names[at].empty(); ++number) {
        std::string unique = fmt::format("{}_{}", name, number);
        if (used.insert(unique).second) names[at] = std::move(unique);
      }
    }
  }
}

void name_parameters(const Program& program, const Function& function,
                     std::vector<std::string>& names) {
  std::vector<std::size_t> uses(function.instructions.size(), 0);
  for (const Instruction& i : function.instructions) {
    if (operand_count(i) > 0) ++uses[i.a];
    if (operand_count(i) > 1) ++uses[i.b];
  }
  for (std::size_t at = 0; at < uses.size(); ++at) {
    const Instruction& i = function.instructions[at];
    if (i.opcode != Opcode::parameter || uses[at] < 2) continue;
    names[at] = identifier_of(program.leaves.parameters[i.a]);
  }
}

}  // namespace

std::vector<std::string> local_names(const Dialect& dialect, const Program& program,
                                     const Function& function) {
  std::vector<std::string> names = temporary_names(program, function);
  const BodyRules rules = dialect.body_rules();
  if (rules.needs_parameter_names) name_parameters(program, function, names);
  std::set<std::string> used;
  for (std::string& name : names) {
    if (name.empty()) continue;
    name = dialect.temporary_name(name);
    const bool is_long = rules.max_name_length > 0 && name.size() > rules.max_name_length;
    if (is_long) name = fmt::format("{}_{}", name.substr(0, truncated_name_length), used.size());
    while (!used.insert(name).second) name += '_';
  }
  if (rules.groups_angles) name_grouped_calls(function, used, names);
  if (rules.max_bracket_depth > 0)
    name_deep_values(function, {rules.max_bracket_depth, used}, names);
  return names;
}

}  // namespace elgen
