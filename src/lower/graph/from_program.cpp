// from_program: one instruction after another.
#include "lower/graph/from_program.hpp"

#include "elgen/fold.hpp"
#include "lower/graph/prune.hpp"

namespace elgen {
namespace {

/// The rules of graphs.
struct GraphRules {
  Graph& graph;

  [[nodiscard]] Ref constant(const Constant& constant) const {
    return graph.constant(constant.form);
  }
  [[nodiscard]] Ref leaf(Opcode kind, std::uint32_t number) const {
    return graph.leaf(kind, number);
  }
  [[nodiscard]] Ref negate(Ref x) const { return -x; }
  [[nodiscard]] Ref add(Ref x, Ref y) const { return graph.sum({x, y}); }
  [[nodiscard]] Ref subtract(Ref x, Ref y) const { return graph.sum({x, -y}); }
  [[nodiscard]] Ref multiply(Ref x, Ref y) const { return graph.product({{x, 1}, {y, 1}}); }
  [[nodiscard]] Ref divide(Ref x, Ref y) const { return graph.product({{x, 1}, {y, -1}}); }
  [[nodiscard]] Ref square_root(Ref x) const { return graph.square_root(x); }
  [[nodiscard]] Ref call(FunctionId function, Ref x, Ref y) const {
    if (function_row(function).arity == 1) return graph.call(function, {x});
    return graph.call(function, {x, y});
  }
};

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
    refs[at] = vanishes ? graph.rational(0)
                        : folded(GraphRules{graph}, program, function.instructions[at], refs);
    graph.name(refs[at], function.names[at]);
  }
  for (const std::uint32_t at : wanted) result.values.push_back(refs[at]);
  return result;
}

}  // namespace elgen
