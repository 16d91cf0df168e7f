// Expressions: a Graph with its outputs, built from the instructions of a Program, or by a rule
// from the nodes of other Expressions.
#pragma once

#include <functional>
#include <vector>

#include "program/graph/graph.hpp"

namespace elgen {

/// A graph and its outputs.
struct Expressions {
  Graph graph = {};
  std::vector<SignedNode> values = {};
};

/// One step of a pass: the old node, and the new values of its operands.
struct RebuildStep {
  const Graph& old_graph;
  NodeId old_node;
  const std::vector<SignedNode>& renewed;  ///< by old NodeId
};

/// Copies the old node, unchanged, to the new graph.
[[nodiscard]] SignedNode copy_node(Graph& graph, const RebuildStep& step);

/// Copies the only value of `from` to another graph.
[[nodiscard]] SignedNode copy_value(Graph& graph, const Expressions& from);

/// Returns the new value of an old node. rebuild() copies creation ranks and names.
using RebuildRule = std::function<SignedNode(Graph&, const RebuildStep&)>;

[[nodiscard]] Expressions rebuild(const Expressions& expressions, const RebuildRule& rule);

/// Rules of fold.hpp that build graph nodes.
struct GraphRules {
  Graph& graph;

  [[nodiscard]] SignedNode constant(const Constant& constant) const {
    return graph.constant(constant.form);
  }
  [[nodiscard]] SignedNode leaf(Opcode kind, std::uint32_t number) const {
    return graph.leaf(kind, number);
  }
  [[nodiscard]] SignedNode negate(SignedNode x) const { return -x; }
  [[nodiscard]] SignedNode add(SignedNode x, SignedNode y) const { return graph.sum({x, y}); }
  [[nodiscard]] SignedNode subtract(SignedNode x, SignedNode y) const { return graph.sum({x, -y}); }
  [[nodiscard]] SignedNode multiply(SignedNode x, SignedNode y) const {
    return graph.product({{x, 1}, {y, 1}});
  }
  [[nodiscard]] SignedNode divide(SignedNode x, SignedNode y) const {
    return graph.product({{x, 1}, {y, -1}});
  }
  [[nodiscard]] SignedNode square_root(SignedNode x) const { return graph.square_root(x); }
  [[nodiscard]] SignedNode call(FunctionId function, SignedNode x, SignedNode y) const {
    if (function_row(function).arity == 1) return graph.call(function, {x});
    return graph.call(function, {x, y});
  }
};

/// The values of the instructions `wanted`. Instructions marked in `is_zero` (empty: none) become 0
/// in all uses, so none of them may be a divisor.
[[nodiscard]] Expressions expressions_from_program(const Program& program, const Function& function,
                                                   const std::vector<std::uint32_t>& wanted,
                                                   const std::vector<bool>& is_zero = {});

}  // namespace elgen
