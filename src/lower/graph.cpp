// Graph: interning, leaves, calls, and the order of nodes. Sums and products are in
// normal_form.cpp.
#include "graph.hpp"

#include <algorithm>
#include <array>
#include <compare>

namespace elgen {
namespace {

std::size_t mixed(std::size_t hash, std::size_t value) {
  return (hash ^ value) * 0x9E3779B97F4A7C15U + (hash >> 29U);
}

std::size_t hash_of(const Node& node) {
  std::size_t hash = mixed(static_cast<std::size_t>(node.kind), node.index);
  hash = mixed(hash,
               static_cast<std::size_t>(node.leaf) * 64 + static_cast<std::size_t>(node.function));
  for (const Operand& operand : node.operands) {
    hash = mixed(hash, operand.node);
    hash = mixed(hash, static_cast<std::size_t>(operand.weight));
  }
  return hash;
}

bool same(const Node& x, const Node& y) {
  return x.kind == y.kind && x.leaf == y.leaf && x.function == y.function && x.index == y.index &&
         x.operands == y.operands;
}

/// m * l * theta * cos(theta) * v: constants, parameters, coordinates, the rest, rates, inputs,
/// time.
int rank(const Node& node) {
  if (node.kind == NodeKind::constant) return 0;
  if (node.kind != NodeKind::leaf) return 3;
  switch (node.leaf) {
    case Opcode::parameter:
      return 1;
    case Opcode::coordinate:
      return 2;
    case Opcode::velocity:
      return 4;
    case Opcode::acceleration:
      return 5;
    case Opcode::input:
      return 6;
    default:
      return 7;
  }
}

template <class T>
int three_way(const T& x, const T& y) {
  return x < y ? -1 : (y < x ? 1 : 0);
}

bool commutes(FunctionId function) {
  return function == FunctionId::min || function == FunctionId::max;
}

}  // namespace

NodeId Graph::intern(Node node) {
  const std::size_t hash = hash_of(node);
  const auto [begin, end] = known_.equal_range(hash);
  for (auto it = begin; it != end; ++it) {
    if (same(nodes_[it->second], node)) return it->second;
  }
  node.birth = birth_;
  const auto id = static_cast<NodeId>(nodes_.size());
  nodes_.push_back(std::move(node));
  known_.emplace(hash, id);
  return id;
}

Ref Graph::constant(const SignedConstant& value) {
  const auto next = static_cast<std::uint32_t>(constants_.size());
  const auto [it, is_new] = constant_index_.emplace(value.constant.text, next);
  if (is_new) constants_.push_back(value.constant);
  return {intern({.kind = NodeKind::constant, .index = it->second}), value.negative};
}

Ref Graph::leaf(Opcode leaf, std::uint32_t index) {
  return {intern({.kind = NodeKind::leaf, .leaf = leaf, .index = index}), false};
}

Ref Graph::square_root(Ref radicand) {
  if (is_constant(radicand.node) && !radicand.negative) {
    return constant(square_root_of(constant_of(radicand.node)));
  }
  const std::int32_t sign = radicand.negative ? -1 : 1;
  return {intern({.kind = NodeKind::square_root, .operands = {{radicand.node, sign}}}), false};
}

Ref Graph::call(FunctionId function, std::vector<Ref> arguments) {
  bool negative = false;
  if (const Parity parity = function_row(function).parity; parity != Parity::none) {
    negative = parity == Parity::odd && arguments[0].negative;
    arguments[0].negative = false;
  }
  if (commutes(function) && less(arguments[1].node, arguments[0].node)) {
    std::swap(arguments[0], arguments[1]);
  }
  const bool all_constant =
      std::all_of(arguments.begin(), arguments.end(), [&](Ref x) { return is_constant(x.node); });
  if (all_constant) {
    std::vector<SignedConstant> values;
    for (const Ref x : arguments) values.push_back(signed_constant(x));
    const SignedConstant value = call_of(function, values);
    if (!value.constant.text.empty()) return with_sign(constant(value), negative);
  }
  Node node{.kind = NodeKind::call, .function = function};
  for (const Ref x : arguments) node.operands.push_back({x.node, x.negative ? -1 : 1});
  return {intern(std::move(node)), negative};
}

void Graph::name(Ref value, const std::string& name) {
  Node& node = nodes_[value.node];
  const bool is_atom = node.kind == NodeKind::leaf || node.kind == NodeKind::constant;
  if (!is_atom && !value.negative && node.name.empty()) node.name = name;
}

bool Graph::is_zero(NodeId id) const {
  return is_constant(id) && cln::zerop(constant_of(id).value);
}

SignedConstant Graph::signed_constant(Ref value) const {
  return {constant_of(value.node), value.negative};
}

void Graph::sort(std::vector<Operand>& operands) const {
  std::sort(operands.begin(), operands.end(),
            [this](const Operand& x, const Operand& y) { return less(x.node, y.node); });
}

int Graph::compare(NodeId x, NodeId y) const {
  if (x == y) return 0;
  const Node& a = nodes_[x];
  const Node& b = nodes_[y];
  if (const int order = three_way(rank(a), rank(b))) return order;
  if (a.kind == NodeKind::constant) return compare_constants(x, y);
  if (a.kind == NodeKind::leaf) return three_way(a.index, b.index);
  if (const int order = three_way(a.birth, b.birth)) return order;
  if (const int order = three_way(a.kind, b.kind)) return order;
  if (const int order = three_way(a.function, b.function)) return order;
  return compare_operands(a, b);
}

int Graph::compare_constants(NodeId x, NodeId y) const {
  const Constant& a = constant_of(x);
  const Constant& b = constant_of(y);
  if (const int order = three_way(a.value, b.value)) return order;
  return three_way(a.text, b.text);
}

int Graph::compare_operands(const Node& x, const Node& y) const {
  const std::size_t shared = std::min(x.operands.size(), y.operands.size());
  for (std::size_t i = 0; i < shared; ++i) {
    if (const int order = compare(x.operands[i].node, y.operands[i].node)) return order;
    if (const int order = three_way(x.operands[i].weight, y.operands[i].weight)) return -order;
  }
  return three_way(x.operands.size(), y.operands.size());
}

std::vector<NodeId> reachable(const Graph& graph, const std::vector<Ref>& outputs) {
  std::vector<bool> needed(graph.size(), false);
  for (const Ref output : outputs) needed[output.node] = true;
  for (std::size_t id = graph.size(); id-- > 0;) {
    if (!needed[id]) continue;
    for (const Operand& operand : graph.node(static_cast<NodeId>(id)).operands) {
      needed[operand.node] = true;
    }
  }
  std::vector<NodeId> nodes;
  for (std::size_t id = 0; id < graph.size(); ++id) {
    if (needed[id]) nodes.push_back(static_cast<NodeId>(id));
  }
  return nodes;
}

std::vector<std::uint32_t> use_counts(const Graph& graph, const std::vector<Ref>& outputs) {
  std::vector<std::uint32_t> counts(graph.size(), 0);
  for (const Ref output : outputs) ++counts[output.node];
  for (const NodeId id : reachable(graph, outputs)) {
    for (const Operand& operand : graph.node(id).operands) ++counts[operand.node];
  }
  return counts;
}

}  // namespace elgen
