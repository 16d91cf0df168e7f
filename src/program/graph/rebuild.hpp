// Expressions: a Graph with the values that are wanted of it: from a Program, the way back from
// instructions to sums and products, or rebuilt from another, node by node, through a rule.
#pragma once

#include <functional>
#include <vector>

#include "program/graph/graph.hpp"

namespace elgen {

/// A graph with the values that are wanted of it.
struct Expressions {
  Graph graph = {};
  std::vector<Ref> values = {};
};

/// Where a pass stands: the old node, and what its operands became.
struct RebuildStep {
  const Graph& old_graph;
  NodeId old_node;
  const std::vector<Ref>& renewed;  ///< by old NodeId
};

/// The old node in the new graph, unchanged.
[[nodiscard]] Ref copy(Graph& graph, const RebuildStep& step);

/// The only value of `from` in another graph.
[[nodiscard]] Ref copied(Graph& graph, const Expressions& from);

/// The new node that a pass makes of an old one; births and names are carried over around it.
using RebuildRule = std::function<Ref(Graph&, const RebuildStep&)>;

[[nodiscard]] Expressions rebuild(const Expressions& expressions, const RebuildRule& rule);

/// The rules of fold.hpp for graphs.
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

/// The values of the instructions `wanted`; those that `is_zero` says (none where it is empty) are
/// 0 wherever they are used, so none of them may divide.
[[nodiscard]] Expressions from_program(const Program& program, const Function& function,
                                       const std::vector<std::uint32_t>& wanted,
                                       const std::vector<bool>& is_zero = {});

}  // namespace elgen
