// prune: backwards over the instructions for what is needed, forwards to renumber it.
#include "program/graph/prune.hpp"

namespace elgen {

std::vector<bool> needed_for(const Function& function, const std::vector<std::uint32_t>& wanted) {
  std::vector<bool> needed(function.instructions.size(), false);
  for (const std::uint32_t at : wanted) needed[at] = true;
  for (std::size_t at = needed.size(); at-- > 0;) {
    const Instruction& i = function.instructions[at];
    if (!needed[at]) continue;
    if (operand_count(i) > 0) needed[i.a] = true;
    if (operand_count(i) > 1) needed[i.b] = true;
  }
  return needed;
}

Function reordered(const Function& function, const std::vector<std::uint32_t>& order) {
  Function result = function;
  result.instructions.clear();
  result.names.clear();
  std::vector<std::uint32_t> renumbered(function.instructions.size());
  for (const std::uint32_t at : order) {
    Instruction i = function.instructions[at];
    if (operand_count(i) > 0) i.a = renumbered[i.a];
    if (operand_count(i) > 1) i.b = renumbered[i.b];
    renumbered[at] = static_cast<std::uint32_t>(result.instructions.size());
    result.instructions.push_back(i);
    result.names.push_back(function.names[at]);
  }
  for (Field& field : result.fields) {
    for (std::uint32_t& entry : field.entries) entry = renumbered[entry];
  }
  return result;
}

Function pruned(const Function& function) {
  const std::vector<bool> needed = needed_for(function, entries_of(function));
  std::vector<std::uint32_t> order;
  for (std::uint32_t at = 0; at < needed.size(); ++at) {
    if (needed[at]) order.push_back(at);
  }
  return reordered(function, order);
}

Function with_entries(Function function, const std::vector<std::uint32_t>& entries) {
  function.fields = {{"", static_cast<std::uint32_t>(entries.size()), 1, entries}};
  return pruned(function);
}

}  // namespace elgen
