// prune: backwards over the instructions for what is needed, forwards to renumber it.
#include "lower/graph/prune.hpp"

#include <utility>

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

Function pruned(Function function) {
  const std::vector<bool> needed = needed_for(function, entries_of(function));
  std::vector<std::uint32_t> renumbered(needed.size());
  std::uint32_t next = 0;
  for (std::size_t at = 0; at < needed.size(); ++at) {
    if (!needed[at]) continue;
    Instruction i = function.instructions[at];
    if (operand_count(i) > 0) i.a = renumbered[i.a];
    if (operand_count(i) > 1) i.b = renumbered[i.b];
    function.instructions[next] = i;
    function.names[next] = std::move(function.names[at]);
    renumbered[at] = next++;
  }
  function.instructions.resize(next);
  function.names.resize(next);
  for (Field& field : function.fields) {
    for (std::uint32_t& entry : field.entries) entry = renumbered[entry];
  }
  return function;
}

}  // namespace elgen
