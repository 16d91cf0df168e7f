// fewer_calls: calls that are made of others of the same argument.
#include <algorithm>
#include <set>

#include "forms/write/graph_terms.hpp"
#include "forms/write/kept_digits.hpp"

namespace elgen {
namespace {

/// The calls that have one beside them that they may be made of.
std::set<NodeId> replaceable_calls(const Expressions& expressions) {
  Graph graph = expressions.graph;
  const std::vector<NodeId> nodes = reachable(graph, expressions.values);
  // Sines have no sign in their arguments.
  const auto has_call = [&](FunctionId function, Ref argument) {
    return std::ranges::any_of(nodes, [&](NodeId id) {
      const Node& node = graph.node(id);
      if (!is_call(node, function)) return false;
      const Ref other = argument_of(node);
      return function == FunctionId::sin ? other.node == argument.node : other == argument;
    });
  };
  std::set<NodeId> found;
  for (const NodeId id : nodes) {
    const Node node = graph.node(id);
    if (!is_sine_or_cosine(node) && !is_call(node, FunctionId::exp)) continue;
    const Ref argument = argument_of(node);
    const bool is_found = is_sine_or_cosine(node)
                              ? has_call(FunctionId::sin, GraphTerms(graph).half(argument))
                              : has_call(FunctionId::expm1, argument);
    if (is_found) found.insert(id);
  }
  return found;
}

Ref with_shared_call(Graph& graph, FunctionId function, Ref argument) {
  const Ref one = graph.rational(1);
  if (function == FunctionId::exp) {
    return graph.sum({one, graph.call(FunctionId::expm1, {argument})});
  }
  const Ref half = GraphTerms(graph).half(argument);
  const Ref sine = graph.call(FunctionId::sin, {half});
  const Ref two = graph.rational(2);
  if (function == FunctionId::cos) return graph.sum({one, -graph.product({{two, 1}, {sine, 2}})});
  return graph.product({{two, 1}, {sine, 1}, {graph.call(FunctionId::cos, {half}), 1}});
}

}  // namespace

std::optional<Expressions> with_fewer_calls(const Expressions& expressions) {
  const std::set<NodeId> calls = replaceable_calls(expressions);
  if (calls.empty()) return std::nullopt;
  const auto rule = [&calls](Graph& graph, const RebuildStep& step) {
    if (!calls.contains(step.old_node)) return copy(graph, step);
    const Node& node = step.old_graph.node(step.old_node);
    const Operand& argument = node.operands[0];
    const Ref renewed = with_sign(step.renewed[argument.node], argument.weight < 0);
    return with_shared_call(graph, node.function, renewed);
  };
  return rebuild(expressions, rule);
}

}  // namespace elgen
