// local_names: takes the names of the program and changes them for the language: a name that would
// hide another gets an underscore, a long name is cut, and a deep formula is split by new names.
#include "emit/code/local_names.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "elgen/leaf_names.hpp"

namespace elgen {
namespace {

/// The start of a name that is too long, which leaves room for a number and underscores.
constexpr std::size_t kept_of_long_name = 40;

/// Brackets in brackets that are read, and the names in use.
struct Bounds {
  std::size_t deepest = 0;
  std::set<std::string> taken = {};
};

/// Gives names to values whose formulas would have more brackets in each other than are read: each
/// instruction that is written out is at most two more.
void name_deep_values(const Function& function, Bounds bounds, std::vector<std::string>& names) {
  std::vector<std::size_t> depths(names.size(), 0);
  std::size_t count = 0;
  for (std::size_t at = 0; at < names.size(); ++at) {
    const Instruction& i = function.instructions[at];
    const std::size_t operands = operand_count(i);
    if (operands == 0) continue;
    const auto depth = [&](std::uint32_t of) { return names[of].empty() ? depths[of] : 0; };
    depths[at] = 2 + std::max(depth(i.a), operands > 1 ? depth(i.b) : 0);
    if (depths[at] <= bounds.deepest || !names[at].empty()) continue;
    do names[at] = fmt::format("inner_{}", ++count);
    while (!bounds.taken.insert(names[at]).second);
  }
}

/// Names parameters that are read more than once.
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
  const BodyRules rules = dialect.rules();
  if (rules.names_parameters) name_parameters(program, function, names);
  std::set<std::string> taken;
  for (std::string& name : names) {
    if (name.empty()) continue;
    name = dialect.temporary(name);
    const bool is_long = rules.longest_name > 0 && name.size() > rules.longest_name;
    if (is_long) name = fmt::format("{}_{}", name.substr(0, kept_of_long_name), taken.size());
    while (!taken.insert(name).second) name += '_';
  }
  if (rules.deepest > 0) name_deep_values(function, {rules.deepest, taken}, names);
  return names;
}

}  // namespace elgen
