// make_network: Graph -> Network, numbered depth-first from the values through operands in
// canonical order.
#include "network.hpp"

#include <map>
#include <optional>

namespace elgen {
namespace {

/// Powers above this are squared repeatedly; up to it their factors may meet others.
constexpr std::int32_t written_out_power = 4;

class Conversion {
 public:
  explicit Conversion(const Expressions& expressions)
      : graph_(expressions.graph), converted_(graph_.size()), divisions_(graph_.size(), 0) {
    for (const NodeId id : reachable(graph_, expressions.values)) {
      if (graph_.node(id).kind != NodeKind::product) continue;
      for (const Operand& factor : graph_.node(id).operands) {
        if (factor.weight < 0) ++divisions_[factor.node];
      }
    }
  }

  Ref convert(Ref value) {
    std::vector<NodeId> pending = {value.node};
    while (!pending.empty()) {
      const NodeId id = pending.back();
      const std::size_t before = pending.size();
      const std::vector<Operand>& operands = graph_.node(id).operands;
      for (std::size_t i = operands.size(); i-- > 0;) {
        if (!converted_[operands[i].node]) pending.push_back(operands[i].node);
      }
      if (pending.size() > before) continue;
      pending.pop_back();
      if (!converted_[id]) converted_[id] = convert_node(id);
    }
    return {*converted_[value.node], value.negative && !graph_.is_zero(value.node)};
  }

  Network network = {};

 private:
  NodeId add(Operation operation) {
    network.operations.push_back(std::move(operation));
    return static_cast<NodeId>(network.operations.size() - 1);
  }

  NodeId add_constant(const Constant& constant) {
    const auto next = static_cast<std::uint32_t>(network.constants.size());
    const auto [it, is_new] = constants_.emplace(constant.text, NodeId{0});
    if (is_new) {
      network.constants.push_back(constant);
      it->second = add({.kind = OperationKind::constant, .index = next});
    }
    return it->second;
  }

  NodeId convert_node(NodeId id) {
    const Node& node = graph_.node(id);
    if (node.kind == NodeKind::constant) return add_constant(graph_.constant_of(id));
    if (node.kind == NodeKind::product) return convert_product(node);
    Operation operation{.leaf = node.leaf, .function = node.function, .index = node.index};
    operation.kind = node.kind == NodeKind::leaf          ? OperationKind::leaf
                     : node.kind == NodeKind::square_root ? OperationKind::square_root
                     : node.kind == NodeKind::call        ? OperationKind::call
                                                          : OperationKind::sum;
    for (const Operand& operand : node.operands) {
      operation.operands.push_back({*converted_[operand.node], operand.weight < 0});
    }
    operation.name = node.name;
    return add(std::move(operation));
  }

  NodeId convert_product(const Node& node) {
    std::vector<Ref> numerator;
    std::vector<Ref> denominator;
    for (const Operand& factor : node.operands) {
      const NodeId base = *converted_[factor.node];
      if (factor.weight > 0) {
        append_power(base, factor.weight, numerator);
      } else if (divisions_[factor.node] > 1) {
        append_power(reciprocal(base), -factor.weight, numerator);
      } else {
        append_power(base, -factor.weight, denominator);
      }
    }
    const NodeId product = product_of(std::move(numerator));
    const NodeId result =
        denominator.empty() ? product : quotient({product, product_of(std::move(denominator))});
    std::string& name = network.operations[result].name;
    if (name.empty()) name = node.name;
    return result;
  }

  void append_power(NodeId base, std::int32_t exponent, std::vector<Ref>& factors) {
    if (exponent <= written_out_power) {
      factors.insert(factors.end(), static_cast<std::size_t>(exponent), Ref{base});
      return;
    }
    if (exponent % 2 != 0) factors.push_back({base});
    append_power(product_of({{base}, {base}}), exponent / 2, factors);
  }

  NodeId product_of(std::vector<Ref> factors) {
    if (factors.empty()) return add_constant(make_constant(1).constant);
    if (factors.size() == 1) return factors[0].node;
    return add({.kind = OperationKind::product, .operands = std::move(factors)});
  }

  NodeId quotient(std::vector<NodeId> operands) {
    return add({.kind = OperationKind::quotient, .operands = {{operands[0]}, {operands[1]}}});
  }

  NodeId reciprocal(NodeId base) {
    const auto [it, is_new] = reciprocals_.emplace(base, NodeId{0});
    if (is_new) it->second = quotient({product_of({}), base});
    return it->second;
  }

  const Graph& graph_;
  std::vector<std::optional<NodeId>> converted_;
  std::vector<std::uint32_t> divisions_;  ///< products that divide by the node
  std::map<NodeId, NodeId> reciprocals_;
  std::map<std::string, NodeId> constants_;
};

}  // namespace

Network make_network(const Expressions& expressions) {
  Conversion conversion(expressions);
  std::vector<Ref> values;
  for (const Ref value : expressions.values) values.push_back(conversion.convert(value));
  conversion.network.values = std::move(values);
  return std::move(conversion.network);
}

}  // namespace elgen
