// mark_literal_calls: see network.hpp. Sums are searched only if the graph has a function of a
// number, and the same function of an argument with this number.
#include <algorithm>
#include <vector>

#include "program/network/network.hpp"

namespace elgen {
namespace {

/// The constant terms of a sum. A constant that is no sum is its own term.
std::vector<Operand> constant_terms(const Graph& graph, NodeId id) {
  std::vector<Operand> terms{{id, 1}};
  if (graph.node(id).kind == NodeKind::sum) terms = graph.node(id).operands;
  std::erase_if(terms, [&](const Operand& term) { return !graph.is_constant(term.node); });
  return terms;
}

/// True if both are the same function, and each argument of `call` has the number as a summand.
bool is_pair(const Graph& graph, NodeId call, NodeId of_number) {
  const Node& x = graph.node(call);
  const Node& y = graph.node(of_number);
  const auto has_summand = [&graph](const Operand& argument, const Operand& number) {
    return argument.weight == number.weight &&
           constant_terms(graph, argument.node) == constant_terms(graph, number.node);
  };
  return x.kind == y.kind && x.function == y.function && !graph.is_constant(call) &&
         std::ranges::equal(x.operands, y.operands, has_summand);
}

/// For each node: true if the node or an operand, direct or not, is wanted.
template <class IsWanted>
std::vector<bool> mark_users(const Graph& graph, const IsWanted& is_wanted) {
  std::vector<bool> result(graph.size());
  for (NodeId id = 0; id < graph.size(); ++id) {
    const auto is_marked = [&](const Operand& operand) -> bool { return result[operand.node]; };
    result[id] = is_wanted(id) || std::ranges::any_of(graph.node(id).operands, is_marked);
  }
  return result;
}

/// True if the node is a sum, and a term is marked in `x` and another term in `y`.
bool are_in_two_terms(const Node& sum, const std::vector<bool>& x, const std::vector<bool>& y) {
  const auto count = [&sum](const auto& is_marked) {
    return std::ranges::count_if(sum.operands, is_marked, &Operand::node);
  };
  return sum.kind == NodeKind::sum && count([&](NodeId id) -> bool { return x[id]; }) > 0 &&
         count([&](NodeId id) -> bool { return y[id]; }) > 0 &&
         count([&](NodeId id) { return x[id] || y[id]; }) > 1;
}

}  // namespace

std::vector<bool> mark_literal_calls(const Expressions& expressions) {
  const Graph& graph = expressions.graph;
  const std::vector<NodeId> nodes = reachable_nodes(graph, expressions.values);
  std::vector<bool> found(graph.size());
  for (const NodeId number : nodes) {
    const NodeKind kind = graph.node(number).kind;
    const bool is_function = kind == NodeKind::call || kind == NodeKind::square_root;
    if (!is_function || !graph.is_constant(number)) continue;
    const auto is_partner = [&](NodeId id) { return is_pair(graph, id, number); };
    if (std::ranges::none_of(nodes, is_partner)) continue;
    const auto with_number = mark_users(graph, [&](NodeId id) { return id == number; });
    const auto with_partner = mark_users(graph, is_partner);
    found[number] = std::ranges::any_of(nodes, [&](NodeId id) {
      return are_in_two_terms(graph.node(id), with_number, with_partner);
    });
  }
  return mark_users(graph, [&](NodeId id) -> bool { return found[id]; });
}

}  // namespace elgen
