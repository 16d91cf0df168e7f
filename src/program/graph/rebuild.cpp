// rebuild: the loop of every pass from Graph to Graph; operands are renewed before their users.
// expressions_from_program: builds the value of one instruction after another.
#include "program/graph/rebuild.hpp"

#include <algorithm>

#include "elgen/fold.hpp"

namespace elgen {

namespace {

/// The terms or arguments of the old node in the new graph, with their signs.
std::vector<SignedNode> renewed_terms(const RebuildStep& step) {
  std::vector<SignedNode> terms;
  terms.reserve(step.old_graph.node(step.old_node).operands.size());
  for (const Operand& operand : step.old_graph.node(step.old_node).operands) {
    terms.push_back(negate_if(step.renewed[operand.node], operand.weight < 0));
  }
  return terms;
}

/// The factors of a product in the new graph.
std::vector<Power> renewed_factors(const RebuildStep& step) {
  std::vector<Power> factors;
  factors.reserve(step.old_graph.node(step.old_node).operands.size());
  for (const Operand& operand : step.old_graph.node(step.old_node).operands) {
    factors.push_back({step.renewed[operand.node], operand.weight});
  }
  return factors;
}

}  // namespace

SignedNode copy_node(Graph& graph, const RebuildStep& step) {
  const Node& node = step.old_graph.node(step.old_node);
  switch (node.kind) {
    case NodeKind::rational:
      return graph.rational(step.old_graph.rational_of(step.old_node));
    case NodeKind::pi:
      return graph.pi();
    case NodeKind::leaf:
      return graph.leaf(node.leaf, node.index);
    case NodeKind::product:
      return graph.product(renewed_factors(step));
    case NodeKind::square_root:
      return graph.square_root(renewed_terms(step)[0]);
    case NodeKind::call:
      return graph.call(node.function, renewed_terms(step));
    case NodeKind::sum:
      return graph.sum(renewed_terms(step));
  }
  return {};
}

SignedNode copy_value(Graph& graph, const Expressions& from) {
  std::vector<SignedNode> renewed(from.graph.size());
  for (const NodeId id : reachable_nodes(from.graph, from.values)) {
    renewed[id] = copy_node(graph, {from.graph, id, renewed});
  }
  const SignedNode value = from.values[0];
  return negate_if(renewed[value.node], value.is_negative);
}

Expressions rebuild(const Expressions& expressions, const RebuildRule& rule) {
  const Graph& old_graph = expressions.graph;
  Expressions result;
  std::vector<SignedNode> renewed(old_graph.size());
  for (const NodeId id : reachable_nodes(old_graph, expressions.values)) {
    result.graph.set_creation_rank(old_graph.node(id).creation_rank);
    renewed[id] = rule(result.graph, {old_graph, id, renewed});
    result.graph.set_name(renewed[id], old_graph.node(id).name);
  }
  for (const SignedNode value : expressions.values) {
    result.values.push_back(negate_if(renewed[value.node], value.is_negative));
  }
  return result;
}

namespace {

/// The graph values of the instructions in `cone`; operator[] takes the index of an instruction.
struct ConeValues {
  const std::vector<std::uint32_t>& cone;
  std::vector<SignedNode> values;

  [[nodiscard]] SignedNode operator[](std::uint32_t at) const {
    const auto place = std::ranges::lower_bound(cone, at);
    return values[static_cast<std::size_t>(place - cone.begin())];
  }
};

}  // namespace

Expressions expressions_from_program(const Program& program, const Function& function,
                                     const std::vector<std::uint32_t>& wanted,
                                     const std::vector<bool>& is_zero) {
  Expressions result;
  Graph& graph = result.graph;
  const std::vector<std::uint32_t> cone = dependency_cone(function, wanted);
  ConeValues refs{cone, {}};
  for (const std::uint32_t at : cone) {
    graph.set_creation_rank(at);
    const bool vanishes = !is_zero.empty() && is_zero[at];
    refs.values.push_back(
        vanishes ? graph.rational(0)
                 : fold_instruction(GraphRules{graph}, program, function.instructions[at], refs));
    graph.set_name(refs.values.back(), function.names[at]);
  }
  for (const std::uint32_t at : wanted) result.values.push_back(refs[at]);
  return result;
}

}  // namespace elgen
