// from_program: one instruction after another.
#include "program/graph/from_program.hpp"

#include "elgen/fold.hpp"

namespace elgen {

Expressions from_program(const Program& program, const Function& function,
                         const std::vector<std::uint32_t>& wanted,
                         const std::vector<bool>& is_zero) {
  const std::vector<bool> needed = needed_for(function, wanted);
  Expressions result;
  Graph& graph = result.graph;
  std::vector<Ref> refs(needed.size());
  for (std::size_t at = 0; at < needed.size(); ++at) {
    if (!needed[at]) continue;
    graph.set_birth(static_cast<std::uint32_t>(at));
    const bool vanishes = !is_zero.empty() && is_zero[at];
    refs[at] = vanishes ? graph.rational(0)
                        : folded(GraphRules{graph}, program, function.instructions[at], refs);
    graph.name(refs[at], function.names[at]);
  }
  for (const std::uint32_t at : wanted) result.values.push_back(refs[at]);
  return result;
}

}  // namespace elgen
