// Graph: interning, leaves, calls, and the order of nodes. For sums and products see
// normal_form.cpp.
#include "program/graph/graph.hpp"

#include <cln/number.h>

#include <algorithm>

#include "elgen/constant.hpp"
#include "numbers/enclosed_number.hpp"

namespace elgen {
namespace {

std::size_t mix_hash(std::size_t hash, std::size_t value) {
  return (hash ^ value) * 0x9E3779B97F4A7C15U + (hash >> 29U);
}

std::size_t hash_of(const Node& node) {
  std::size_t hash = mix_hash(static_cast<std::size_t>(node.kind), node.index);
  hash = mix_hash(
      hash, static_cast<std::size_t>(node.leaf) * 64 + static_cast<std::size_t>(node.function));
  for (const Operand& operand : node.operands) {
    hash = mix_hash(hash, operand.node);
    hash = mix_hash(hash, static_cast<std::size_t>(operand.weight));
  }
  return hash;
}

bool is_same_node(const Node& x, const Node& y) {
  return x.kind == y.kind && x.leaf == y.leaf && x.function == y.function && x.index == y.index &&
         x.operands == y.operands;
}

/// The rank of a node in the order of operands, as in 2 * pi * m * l * theta * cos(theta) * v:
/// numbers, constants, parameters, coordinates, nodes that are not leaves, open values, rates,
/// inputs, time.
int rank(const Node& node) {
  if (node.kind == NodeKind::rational) return 0;
  if (node.constant_size > 0) return 1;
  return node.kind == NodeKind::leaf ? leaf_row(node.leaf).rank : 4;
}

template <class T>
int compare_three_way(const T& x, const T& y) {
  return x < y ? -1 : (y < x ? 1 : 0);
}

bool commutes(FunctionId function) {
  return function == FunctionId::min || function == FunctionId::max ||
         function == FunctionId::hypot;
}

}  // namespace

std::uint32_t Graph::constant_size(const Node& node) const {
  if (node.kind == NodeKind::leaf) return 0;
  std::uint32_t size = 1;
  for (const Operand& operand : node.operands) {
    if (!is_constant(operand.node)) return 0;
    size = std::min(size + nodes_[operand.node].constant_size, most_constant_nodes);
  }
  return size;
}

NodeId Graph::intern(Node node) {
  const std::size_t hash = hash_of(node);
  const auto [begin, end] = known_.equal_range(hash);
  for (auto it = begin; it != end; ++it) {
    if (is_same_node(nodes_[it->second], node)) return it->second;
  }
  node.constant_size = constant_size(node);
  // A constant is written in the same order wherever it appears, so its creation rank is 0.
  node.creation_rank = node.constant_size > 0 ? 0 : creation_rank_;
  const auto id = static_cast<NodeId>(nodes_.size());
  nodes_.push_back(std::move(node));
  known_.emplace(hash, id);
  return id;
}

SignedNode Graph::rational(const cln::cl_RA& value) {
  if (one_ && value == 1) return {*one_, false};
  const cln::cl_RA magnitude = cln::abs(value);
  const auto [known, is_new] = rational_nodes_.try_emplace(magnitude, 0);
  if (is_new) {
    const auto next = static_cast<std::uint32_t>(rationals_.size());
    rationals_.push_back(magnitude);
    known->second = intern({.kind = NodeKind::rational, .index = next});
    if (magnitude == 1) one_ = known->second;
  }
  return {known->second, cln::minusp(value)};
}

SignedNode Graph::pi() { return {intern({.kind = NodeKind::pi}), false}; }

SignedNode Graph::leaf(Opcode leaf, std::uint32_t index) {
  return {intern({.kind = NodeKind::leaf, .leaf = leaf, .index = index}), false};
}

SignedNode Graph::square_root(SignedNode radicand) {
  cln::cl_RA root;
  const bool is_square = is_rational(radicand.node) && !radicand.is_negative &&
                         cln::sqrtp(rational_of(radicand.node), &root);
  if (is_square) return rational(root);
  const std::int32_t sign = radicand.is_negative ? -1 : 1;
  return {intern({.kind = NodeKind::square_root, .operands = {{radicand.node, sign}}}), false};
}

std::optional<cln::cl_RA> Graph::rational_value(SignedNode value) const {
  if (!is_rational(value.node)) return std::nullopt;
  return value.is_negative ? -rational_of(value.node) : rational_of(value.node);
}

std::optional<int> Graph::constant_sign(SignedNode value) const {
  if (!has_constant_form(value.node)) return std::nullopt;
  const auto enclosure = enclosed_value(constant_form(value.node));
  const auto sign = enclosure ? sign_of(*enclosure) : std::nullopt;
  return sign && value.is_negative ? std::optional(-*sign) : sign;
}

/// The value of abs, sign, min or max of constants; none if an argument is not constant or a sign
/// is undecided.
std::optional<SignedNode> Graph::fold_kinked_call(FunctionId function,
                                                  const std::vector<SignedNode>& arguments) {
  const SignedNode x = arguments.front();
  if (arguments.size() == 1) {
    const auto sign = constant_sign(x);
    if (!sign) return std::nullopt;
    return function == FunctionId::sign ? rational(*sign) : negate_if(x, *sign < 0);
  }
  if (!is_constant(x.node) || !is_constant(arguments.back().node)) return std::nullopt;
  const auto order = constant_sign(sum({x, -arguments.back()}));
  if (!order) return std::nullopt;
  return (*order < 0) == (function == FunctionId::min) ? x : arguments.back();
}

/// The value of the call, if the value is plus or minus an argument, or a number known without
/// rounding; else none.
std::optional<SignedNode> Graph::fold_exact_call(FunctionId function,
                                                 const std::vector<SignedNode>& arguments) {
  if (is_kinked(function)) return fold_kinked_call(function, arguments);
  const std::optional<cln::cl_RA> x = rational_value(arguments.front());
  const std::optional<cln::cl_RA> y = rational_value(arguments.back());
  if (!x || !y) return std::nullopt;
  const std::optional<cln::cl_RA> value = exact_function_value(function, *x, *y);
  return value ? std::optional(rational(*value)) : std::nullopt;
}

SignedNode Graph::call(FunctionId function, std::vector<SignedNode> arguments) {
  bool negative = false;
  if (const Parity parity = function_row(function).parity; parity != Parity::none) {
    negative = parity == Parity::odd && arguments[0].is_negative;
    const std::size_t symmetric = function == FunctionId::stumpff ? 1 : arguments.size();
    for (std::size_t i = 0; i < symmetric; ++i) arguments[i].is_negative = false;
  }
  if (commutes(function) && less(arguments[1].node, arguments[0].node)) {
    std::swap(arguments[0], arguments[1]);
  }
  if (const auto exact = fold_exact_call(function, arguments)) return negate_if(*exact, negative);
  Node node{.kind = NodeKind::call, .function = function};
  for (const SignedNode x : arguments) node.operands.push_back({x.node, x.is_negative ? -1 : 1});
  return {intern(std::move(node)), negative};
}

/// Sums in sums are spliced, so that equal numbers have equal forms more often.
SignedNode Graph::constant(const ConstantForm& form) {
  std::vector<Power> factors;
  std::vector<SignedNode> parts;
  for (const ConstantOperand& part : form.operands) {
    const SignedNode value = constant(part.form);
    const SignedNode term = negate_if(value, part.weight < 0);
    factors.push_back({value, part.weight});
    if (form.kind != ConstantKind::sum || node(value.node).kind != NodeKind::sum) {
      parts.push_back(term);
      continue;
    }
    for (const Operand& operand : node(value.node).operands) {
      parts.push_back(negate_if({operand.node, operand.weight < 0}, term.is_negative));
    }
  }
  switch (form.kind) {
    case ConstantKind::rational:
      return rational(form.number);
    case ConstantKind::pi:
      return pi();
    case ConstantKind::sum:
      return sum(parts);
    case ConstantKind::product:
      return product(factors);
    case ConstantKind::square_root:
      return square_root(parts.front());
    case ConstantKind::call:
      return call(form.function, parts);
  }
  return {};
}

ConstantForm Graph::constant_form(NodeId id) const {
  const Node& node = nodes_[id];
  if (node.kind == NodeKind::rational) return rational_form(rational_of(id));
  ConstantForm form{.function = node.function, .operands = {}};
  form.kind = node.kind == NodeKind::pi            ? ConstantKind::pi
              : node.kind == NodeKind::sum         ? ConstantKind::sum
              : node.kind == NodeKind::product     ? ConstantKind::product
              : node.kind == NodeKind::square_root ? ConstantKind::square_root
                                                   : ConstantKind::call;
  for (const Operand& operand : node.operands) {
    form.operands.push_back({constant_form(operand.node), operand.weight});
  }
  return form;
}

ConstantForm Graph::form_of(SignedNode value) const {
  ConstantForm form = constant_form(value.node);
  return value.is_negative ? negated_form(std::move(form)) : form;
}

void Graph::set_name(SignedNode value, const std::string& name) {
  Node& node = nodes_[value.node];
  const bool is_atom = node.kind == NodeKind::leaf || node.constant_size > 0;
  if (!is_atom && !value.is_negative) merge_name(node.name, name);
}

bool Graph::is_zero(NodeId id) const { return is_rational(id) && cln::zerop(rational_of(id)); }

void Graph::sort(std::vector<Operand>& operands) const {
  std::sort(operands.begin(), operands.end(),
            [this](const Operand& x, const Operand& y) { return less(x.node, y.node); });
}

int Graph::compare(NodeId x, NodeId y) const {
  if (x == y) return 0;
  const Node& a = nodes_[x];
  const Node& b = nodes_[y];
  if (const int order = compare_three_way(rank(a), rank(b))) return order;
  if (a.kind == NodeKind::rational) return compare_three_way(rational_of(x), rational_of(y));
  if (a.kind == NodeKind::leaf) return compare_three_way(a.index, b.index);
  if (const int order = compare_three_way(a.creation_rank, b.creation_rank)) return order;
  if (const int order = compare_three_way(a.kind, b.kind)) return order;
  if (const int order = compare_three_way(a.function, b.function)) return order;
  return compare_operands(a, b);
}

int Graph::compare_operands(const Node& x, const Node& y) const {
  const std::size_t shared = std::min(x.operands.size(), y.operands.size());
  for (std::size_t i = 0; i < shared; ++i) {
    if (const int order = compare(x.operands[i].node, y.operands[i].node)) return order;
    if (const int order = compare_three_way(x.operands[i].weight, y.operands[i].weight))
      return -order;
  }
  return compare_three_way(x.operands.size(), y.operands.size());
}

std::vector<NodeId> reachable_nodes(const Graph& graph, const std::vector<SignedNode>& outputs) {
  std::vector<bool> needed(graph.size(), false);
  for (const SignedNode output : outputs) needed[output.node] = true;
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

std::vector<std::uint32_t> use_counts(const Graph& graph, const std::vector<SignedNode>& outputs) {
  std::vector<std::uint32_t> counts(graph.size(), 0);
  for (const SignedNode output : outputs) ++counts[output.node];
  for (const NodeId id : reachable_nodes(graph, outputs)) {
    for (const Operand& operand : graph.node(id).operands) ++counts[operand.node];
  }
  return counts;
}

}  // namespace elgen
