// make_network: Graph -> Network. Operations are numbered depth-first from the values, operands in
// canonical order.
#include "program/network/network.hpp"

#include <cln/integer.h>

#include <algorithm>
#include <map>
#include <optional>
#include <utility>

namespace elgen {
namespace {

/// Powers up to this exponent are products of repeated factors, which may be shared. Higher powers
/// are computed by repeated squaring.
constexpr std::int32_t most_repeated_factors = 4;

/// Constants with more nodes are not joined: the form of a constant is a tree, which would grow
/// with each joining, and a person would not join long constants either.
constexpr std::uint32_t largest_joined_constant = 64;

/// The operands of a sum or product: operands with leaves, and all constants as one number.
struct FoldedOperands {
  std::vector<Operand> rest = {};
  std::optional<NodeId> constant = {};  ///< the operation of the number
  bool is_negative = false;             ///< the constant is negative
};

/// The operations of a network. Each number and each reciprocal is one operation.
class NetworkBuilder {
 public:
  NodeId add(Operation operation) {
    network.operations.push_back(std::move(operation));
    return static_cast<NodeId>(network.operations.size() - 1);
  }

  /// The operation of the form's magnitude, with the form's sign; none if the form has no value.
  std::optional<SignedNode> add_constant(const ConstantForm& form) {
    Graph scratch;
    std::optional<Constant> constant = make_constant(scratch.form_of(scratch.constant(form)));
    if (!constant) return std::nullopt;
    const bool negative = cln::minusp(constant->value);
    if (negative) *constant = {-constant->value, negated_form(std::move(constant->form))};
    return SignedNode{add_number(*constant), negative};
  }

  void append_power(NodeId base, std::int32_t exponent, std::vector<SignedNode>& factors) {
    if (exponent <= most_repeated_factors) {
      factors.insert(factors.end(), static_cast<std::size_t>(exponent), SignedNode{base});
      return;
    }
    if (exponent % 2 != 0) factors.push_back({base});
    append_power(add_product({{base}, {base}}), exponent / 2, factors);
  }

  NodeId add_product(std::vector<SignedNode> factors) {
    if (factors.empty()) return add_number(rational_constant(1));
    if (factors.size() == 1) return factors[0].node;
    return add({.kind = OperationKind::product, .operands = std::move(factors)});
  }

  NodeId add_quotient(NodeId above, NodeId below) {
    return add({.kind = OperationKind::quotient, .operands = {{above}, {below}}});
  }

  NodeId add_reciprocal(NodeId base) {
    const auto [it, is_new] = reciprocals_.emplace(base, NodeId{0});
    if (is_new) it->second = add_quotient(add_product({}), base);
    return it->second;
  }

  /// True if `sum` is a sum with at most one exact coefficient (n/2^k), so that scaling costs no
  /// digits. x - y has two exact coefficients, and keeps digits that 0.7 x - 0.7 y loses.
  bool can_scale_sum(NodeId sum) const {
    const auto is_exact = [this](SignedNode term) {
      const ConstantForm number = split_number(term).first;
      return number.kind == ConstantKind::rational &&
             cln::power2p(cln::denominator(number.number)) > 0;
    };
    const Operation& operation = network.operations[sum];
    return operation.kind == OperationKind::sum &&
           std::ranges::count_if(operation.operands, is_exact) <= 1;
  }

  /// Multiplies the terms by `scale`, if it is set, and merges terms that differ only in their
  /// numeric factors. If a new factor has no value or too many nodes, returns false and changes
  /// nothing.
  bool merge_like_terms(std::vector<SignedNode>& terms, std::optional<NodeId> scale = {}) {
    struct Group {
      std::vector<SignedNode> rest;
      ConstantForm number;
      SignedNode last;
    };
    std::vector<Group> groups;
    for (const SignedNode term : terms) {
      auto [number, rest] = split_number(term);
      auto group = std::ranges::find(groups, rest, &Group::rest);
      if (group == groups.end()) {
        group = groups.insert(group,
                              {std::move(rest), {.kind = ConstantKind::sum, .operands = {}}, term});
      }
      group->number.operands.push_back({std::move(number), term.is_negative ? -1 : 1});
    }
    std::vector<SignedNode> joined;
    for (auto& [rest, sum, last] : groups) {
      ConstantForm form{.kind = ConstantKind::product, .operands = {{sum}}};
      if (scale) form.operands.push_back({form_of(*scale)});
      const bool is_new = scale || sum.operands.size() > 1;
      const std::optional<SignedNode> number =
          is_new && is_small_enough_to_join(form) ? add_constant(form) : std::nullopt;
      if (is_new && !number) return false;
      if (is_new && (number->node != add_product({}) || rest.empty())) {
        rest.insert(rest.begin(), {number->node});
      }
      joined.push_back(is_new ? SignedNode{add_product(std::move(rest)), number->is_negative}
                              : last);
    }
    terms = std::move(joined);
    return true;
  }

  Network network = {};

 private:
  const ConstantForm& form_of(NodeId constant) const {
    return network.constants[network.operations[constant].index].form;
  }

  static bool is_small_enough_to_join(const ConstantForm& form) {
    Graph scratch;
    return scratch.node(scratch.constant(form).node).constant_size <= largest_joined_constant;
  }

  /// The numeric factor of a term, and its other factors.
  std::pair<ConstantForm, std::vector<SignedNode>> split_number(SignedNode term) const {
    const Operation& operation = network.operations[term.node];
    std::vector<SignedNode> rest{{term.node}};
    if (operation.kind == OperationKind::product) rest = operation.operands;
    const NodeId first = rest.front().node;
    if (network.operations[first].kind != OperationKind::constant) return {rational_form(1), rest};
    rest.erase(rest.begin());
    return {form_of(first), rest};
  }

  NodeId add_number(const Constant& constant) {
    const std::uint32_t index = intern_constant(constant, network.constants);
    if (index == numbers_.size()) {
      numbers_.push_back(add({.kind = OperationKind::constant, .index = index}));
    }
    return numbers_[index];
  }

  std::vector<NodeId> numbers_ = {};  ///< parallel to Network::constants
  std::map<NodeId, NodeId> reciprocals_ = {};
};

/// The number of products that divide by each node.
std::vector<std::uint32_t> division_counts(const Graph& graph,
                                           const std::vector<SignedNode>& values) {
  std::vector<std::uint32_t> counts(graph.size(), 0);
  for (const NodeId id : reachable_nodes(graph, values)) {
    if (graph.node(id).kind != NodeKind::product) continue;
    for (const Operand& factor : graph.node(id).operands) {
      if (factor.weight < 0) ++counts[factor.node];
    }
  }
  return counts;
}

class NetworkConverter {
 public:
  NetworkConverter(const Expressions& expressions, NumberJoining numbers)
      : graph_(expressions.graph),
        converted_(graph_.size()),
        stays_call_(mark_literal_calls(expressions)),
        divisions_(division_counts(graph_, expressions.values)) {
    if (numbers == NumberJoining::joined) uses_ = use_counts(graph_, expressions.values);
  }

  Network convert_values(const std::vector<SignedNode>& values) && {
    for (const SignedNode value : values) builder_.network.values.push_back(convert(value));
    return std::move(builder_.network);
  }

 private:
  SignedNode convert(SignedNode value) {
    std::vector<NodeId> pending = {value.node};
    while (!pending.empty()) {
      const NodeId id = pending.back();
      const std::size_t before = pending.size();
      const std::vector<Operand> operands = needed_operands(id);
      for (std::size_t i = operands.size(); i-- > 0;) {
        if (!converted_[operands[i].node]) pending.push_back(operands[i].node);
      }
      if (pending.size() > before) continue;
      pending.pop_back();
      if (!converted_[id]) converted_[id] = convert_node(id);
    }
    const SignedNode result = *converted_[value.node];
    return negate_if(result, value.is_negative && !graph_.is_zero(value.node));
  }

  /// True for constants that code has as numbers.
  bool is_number(NodeId id) const { return graph_.has_constant_form(id) && !stays_call_[id]; }

  /// Operands with all constants folded into one: 1/2*pi*x multiplies x by one number. Memoised.
  const FoldedOperands& operands_of(NodeId id) {
    const auto [at, is_new] = operands_.try_emplace(id);
    if (!is_new) return at->second;
    FoldedOperands result;
    ConstantForm form;
    const Node& node = graph_.node(id);
    form.kind = node.kind == NodeKind::sum ? ConstantKind::sum : ConstantKind::product;
    for (const Operand& operand : node.operands) {
      if (is_number(operand.node)) {
        form.operands.push_back({graph_.constant_form(operand.node), operand.weight});
      } else {
        result.rest.push_back(operand);
      }
    }
    const auto number = form.operands.empty() ? std::nullopt : builder_.add_constant(form);
    if (number) {
      result.constant = number->node;
      result.is_negative = number->is_negative;
    } else {
      result.rest = node.operands;
    }
    return at->second = std::move(result);
  }

  /// Operands that must be converted before the node.
  std::vector<Operand> needed_operands(NodeId id) {
    const NodeKind kind = graph_.node(id).kind;
    if (is_number(id) && fold_constant(id)) return {};
    const bool is_n_ary = kind == NodeKind::sum || kind == NodeKind::product;
    return is_n_ary ? operands_of(id).rest : graph_.node(id).operands;
  }

  /// Converts a constant node to a number; false if it has no value.
  bool fold_constant(NodeId id) {
    if (!converted_[id]) converted_[id] = builder_.add_constant(graph_.constant_form(id));
    return converted_[id].has_value();
  }

  SignedNode convert_node(NodeId id) {
    const Node& node = graph_.node(id);
    if (node.kind == NodeKind::product) return convert_product(id);
    Operation operation{.leaf = node.leaf, .function = node.function, .index = node.index};
    operation.kind = node.kind == NodeKind::leaf          ? OperationKind::leaf
                     : node.kind == NodeKind::square_root ? OperationKind::square_root
                     : node.kind == NodeKind::call        ? OperationKind::call
                                                          : OperationKind::sum;
    operation.name = node.name;
    const bool is_sum = node.kind == NodeKind::sum;
    // Constant terms come first in a sum, so their sum, the folded constant, comes first, too.
    if (is_sum && operands_of(id).constant) {
      operation.operands.push_back({*operands_of(id).constant, operands_of(id).is_negative});
    }
    for (const Operand& operand : is_sum ? operands_of(id).rest : node.operands) {
      const SignedNode value = negate_if(*converted_[operand.node], operand.weight < 0);
      std::vector<SignedNode> terms{{value.node}};
      // Joining numbers may have turned the product into a sum.
      const Operation& made = builder_.network.operations[value.node];
      const bool is_spliced = is_sum && has_single_use(operand.node) &&
                              made.kind == OperationKind::sum && !is_difference_of_coordinate(made);
      if (is_spliced) terms = made.operands;
      for (const SignedNode term : terms)
        operation.operands.push_back(negate_if(term, value.is_negative));
    }
    if (is_sum && !uses_.empty()) builder_.merge_like_terms(operation.operands);
    if (is_sum) put_coordinates_first(operation.operands);
    return {builder_.add(std::move(operation))};
  }

  /// True for q - p, which is a part of (q - p) - r and is computed first.
  [[nodiscard]] bool is_difference_of_coordinate(const Operation& sum) const {
    const auto is_leaf_of = [&](Opcode leaf) {
      return
          [this, leaf](SignedNode x) { return builder_.network.operations[x.node].leaf == leaf; };
    };
    return sum.operands.size() == 2 &&
           std::ranges::any_of(sum.operands, is_leaf_of(Opcode::coordinate)) &&
           std::ranges::any_of(sum.operands, is_leaf_of(Opcode::parameter));
  }

  /// q - p - r instead of p + r - q, for q near p + r: q - p is exact if p >= r, but p + r is
  /// rounded. Changes only sums of two or more parameters and of coordinates.
  void put_coordinates_first(std::vector<SignedNode>& terms) const {
    const auto is_leaf_term = [this](Opcode leaf) {
      return [this, leaf](SignedNode x) {
        const Operation& term = builder_.network.operations[x.node];
        return term.kind == OperationKind::leaf && term.leaf == leaf;
      };
    };
    const auto is_parameter = is_leaf_term(Opcode::parameter);
    const auto is_coordinate = is_leaf_term(Opcode::coordinate);
    const auto parameters = std::ranges::count_if(terms, is_parameter);
    const auto coordinates = std::ranges::count_if(terms, is_coordinate);
    if (parameters < 2 || parameters + coordinates != std::ssize(terms)) return;
    std::stable_partition(terms.begin(), terms.end(), is_coordinate);
  }

  SignedNode convert_product(NodeId id) {
    const Node& node = graph_.node(id);
    const FoldedOperands& operands = operands_of(id);
    std::vector<SignedNode> numerator;
    std::vector<SignedNode> denominator;
    bool negative = operands.is_negative;
    bool has_number = operands.constant.has_value();
    for (const Operand& factor : operands.rest) {
      const SignedNode base = *converted_[factor.node];
      negative = negative != (base.is_negative && factor.weight % 2 != 0);
      if (has_number && factor.weight == 1 && has_single_use(factor.node)) {
        has_number = !multiply_into_sum(base.node, *operands.constant);
      }
      if (factor.weight > 0) {
        builder_.append_power(base.node, factor.weight, numerator);
      } else if (divisions_[factor.node] > 1) {
        builder_.append_power(builder_.add_reciprocal(base.node), -factor.weight, numerator);
      } else {
        builder_.append_power(base.node, -factor.weight, denominator);
      }
    }
    if (has_number) numerator.insert(numerator.begin(), {*operands.constant});
    NodeId result = builder_.add_product(std::move(numerator));
    if (!denominator.empty()) {
      result = builder_.add_quotient(result, builder_.add_product(std::move(denominator)));
    }
    if (!negative) merge_name(builder_.network.operations[result].name, node.name);
    return {result, negative};
  }

  /// True if numbers are joined and only one operation uses the node.
  bool has_single_use(NodeId id) const { return !uses_.empty() && uses_[id] == 1; }

  bool multiply_into_sum(NodeId sum, NodeId number) {
    if (!builder_.can_scale_sum(sum)) return false;
    std::vector<SignedNode> terms = builder_.network.operations[sum].operands;
    if (!builder_.merge_like_terms(terms, number)) return false;
    builder_.network.operations[sum] = {.kind = OperationKind::sum, .operands = std::move(terms)};
    return true;
  }

  const Graph& graph_;
  std::vector<std::optional<SignedNode>> converted_;
  std::vector<bool> stays_call_;               ///< by mark_literal_calls()
  std::vector<std::uint32_t> uses_;            ///< empty unless numbers are joined
  std::vector<std::uint32_t> divisions_;       ///< number of products that divide by each node
  std::map<NodeId, FoldedOperands> operands_;  ///< of sums and products
  NetworkBuilder builder_;
};

}  // namespace

Network make_network(const Expressions& expressions, NumberJoining numbers) {
  return NetworkConverter(expressions, numbers).convert_values(expressions.values);
}

}  // namespace elgen
