// from_program: one instruction after another.
#include "from_program.hpp"

#include "prune.hpp"

namespace elgen {
namespace {

Ref graph_of(Graph& graph, const Program& program, const Instruction& i,
             const std::vector<Ref>& refs) {
  switch (i.opcode) {
    case Opcode::constant:
      return graph.constant(program.constants[i.a].form);
    case Opcode::negate:
      return -refs[i.a];
    case Opcode::add:
      return graph.sum({refs[i.a], refs[i.b]});
    case Opcode::subtract:
      return graph.sum({refs[i.a], -refs[i.b]});
    case Opcode::multiply:
      return graph.product({{refs[i.a], 1}, {refs[i.b], 1}});
    case Opcode::divide:
      return graph.product({{refs[i.a], 1}, {refs[i.b], -1}});
    case Opcode::square_root:
      return graph.square_root(refs[i.a]);
    case Opcode::call:
      if (function_row(i.function).arity == 1) return graph.call(i.function, {refs[i.a]});
      return graph.call(i.function, {refs[i.a], refs[i.b]});
    default:
      return graph.leaf(i.opcode, i.opcode == Opcode::time ? 0 : i.a);
  }
}

}  // namespace

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
    refs[at] =
        vanishes ? graph.rational(0) : graph_of(graph, program, function.instructions[at], refs);
    graph.name(refs[at], function.names[at]);
  }
  for (const std::uint32_t at : wanted) result.values.push_back(refs[at]);
  return result;
}

}  // namespace elgen
