// rebuild: copies what some outputs need of a Graph into a new Graph, node by node, through a rule.
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

}  // namespace elgen
