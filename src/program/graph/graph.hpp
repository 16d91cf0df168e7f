// Graph: hash-consed n-ary sums and products, canonical up to sign, in elgen's own order.
//
// A SignedNode is a node and a sign, so negation is free: products carry no sign, the leading term
// of a sum is positive, sin(-x) = -sin(x), cos(-x) = cos(x). Equal terms and equal bases are merged
// with exact coefficients. less() orders operands: rational numbers, constants, leaves by kind and
// declaration, then all other nodes by creation rank and structure. The creation rank of a node is
// the index of the definition or instruction whose import first built the node. The order in which
// operands are passed has no effect. pi, roots and functions of numbers are ordinary nodes: only
// rational numbers are evaluated.
#pragma once

#include <cln/rational.h>

#include <cstdint>
#include <optional>
#include <string>
#include <unordered_map>
#include <vector>

#include "elgen/program.hpp"

namespace elgen {

using NodeId = std::uint32_t;

struct SignedNode {
  NodeId node = 0;
  bool is_negative = false;
  friend bool operator==(const SignedNode&, const SignedNode&) = default;
};

[[nodiscard]] inline SignedNode operator-(SignedNode x) { return {x.node, !x.is_negative}; }

/// -x if `condition`, else x.
[[nodiscard]] inline SignedNode negate_if(SignedNode x, bool condition) {
  return {x.node, x.is_negative != condition};
}

enum class NodeKind : std::uint8_t { rational, pi, leaf, product, square_root, call, sum };

/// weight: the exponent (not 0) in a product, the sign (1 or -1) in any other node.
struct Operand {
  NodeId node = 0;
  std::int32_t weight = 1;
  friend bool operator==(const Operand&, const Operand&) = default;
};

struct Node {
  NodeKind kind = NodeKind::rational;
  Opcode leaf = Opcode::constant;         ///< of a leaf
  FunctionId function = FunctionId::sin;  ///< of a call
  std::uint32_t index = 0;                ///< of the leaf or the rational number
  std::vector<Operand> operands = {};     ///< a rational factor or term comes first, then constants
  std::uint32_t creation_rank = 0;
  /// The number of nodes of a constant as a tree, at most most_constant_nodes. 0: the node contains
  /// leaves.
  std::uint32_t constant_size = 0;
  std::string name = {};  ///< for readers; "" if the node has no name
  /// Cache: the product without its rational coefficient.
  std::optional<NodeId> unscaled = {};
};

[[nodiscard]] inline bool is_call(const Node& node, FunctionId function) {
  return node.kind == NodeKind::call && node.function == function;
}

[[nodiscard]] inline bool is_sine_or_cosine(const Node& node) {
  return node.kind == NodeKind::call && is_circular(node.function);
}

/// A constant with this many nodes has no form: the form is a tree, which repeats shared nodes and
/// would outgrow the graph.
inline constexpr std::uint32_t most_constant_nodes = 400;

struct Power {
  SignedNode base;
  std::int32_t exponent = 1;
};

class Graph {
 public:
  /// Sets the creation rank of nodes that are first built from now on. Higher ranks come later in
  /// the order.
  void set_creation_rank(std::uint32_t birth) { creation_rank_ = birth; }

  SignedNode rational(const cln::cl_RA& value);
  SignedNode pi();
  SignedNode leaf(Opcode leaf, std::uint32_t index);
  SignedNode sum(const std::vector<SignedNode>& terms);
  /// The product of all powers. A base with a negative exponent must not be the number 0.
  SignedNode product(const std::vector<Power>& powers);
  SignedNode square_root(SignedNode radicand);
  SignedNode call(FunctionId function, std::vector<SignedNode> arguments);

  /// The value of `form`, built node by node; sums in sums and products in products are spliced.
  SignedNode constant(const ConstantForm& form);

  /// Names the node, see merge_name. Leaves, constants and negated values are skipped.
  void set_name(SignedNode value, const std::string& name);

  [[nodiscard]] const Node& node(NodeId id) const { return nodes_[id]; }
  [[nodiscard]] std::size_t size() const { return nodes_.size(); }
  [[nodiscard]] bool is_constant(NodeId id) const { return node(id).constant_size > 0; }
  [[nodiscard]] bool has_constant_form(NodeId id) const {
    return is_constant(id) && node(id).constant_size < most_constant_nodes;
  }
  [[nodiscard]] bool is_rational(NodeId id) const { return node(id).kind == NodeKind::rational; }
  /// The value of a rational node; never negative.
  [[nodiscard]] const cln::cl_RA& rational_of(NodeId id) const {
    return rationals_[node(id).index];
  }
  [[nodiscard]] bool is_zero(NodeId id) const;
  /// The form of a constant; has_constant_form(id) must be true.
  [[nodiscard]] ConstantForm constant_form(NodeId id) const;
  [[nodiscard]] ConstantForm form_of(SignedNode value) const;

  /// True if x precedes y in the total order, which is strict and the same in every process.
  [[nodiscard]] bool less(NodeId x, NodeId y) const { return compare(x, y) < 0; }

 private:
  struct Factors;
  struct Term;

  NodeId intern(Node node);
  [[nodiscard]] std::uint32_t constant_size(const Node& node) const;
  [[nodiscard]] int compare(NodeId x, NodeId y) const;
  [[nodiscard]] int compare_operands(const Node& x, const Node& y) const;
  void sort(std::vector<Operand>& operands) const;

  [[nodiscard]] std::optional<cln::cl_RA> rational_value(SignedNode value) const;
  [[nodiscard]] std::optional<int> constant_sign(SignedNode value) const;
  [[nodiscard]] std::optional<SignedNode> fold_kinked_call(
      FunctionId function, const std::vector<SignedNode>& arguments);
  std::optional<SignedNode> fold_exact_call(FunctionId function,
                                            const std::vector<SignedNode>& arguments);
  void collect_factors(const Power& power, Factors& factors);
  void merge_factors(Factors& factors);
  bool join_hyperbolic_quotient(std::vector<Operand>& powers);
  bool join_logistic_quotient(std::vector<Operand>& powers);
  [[nodiscard]] std::optional<SignedNode> logistic_argument(NodeId id) const;
  SignedNode build_product(Factors factors);
  std::optional<Term> scaled_product(NodeId id);
  Term split_coefficient(SignedNode term);
  [[nodiscard]] std::size_t squared_sine_index(NodeId id) const;
  template <class Choice>
  std::vector<Term*> sorted_terms(std::vector<Term>& terms, const Choice& is_chosen) const;
  bool join_squares(std::vector<Term>& terms);
  bool expand_opposite_terms(std::vector<Term>& terms);
  static void merge_terms(std::vector<Term>& terms);
  SignedNode build_sum(const std::vector<Term>& terms, const cln::cl_RA& constant);

  struct RationalHash {
    std::size_t operator()(const cln::cl_RA& x) const { return cln::equal_hashcode(x); }
  };
  std::vector<Node> nodes_;
  std::vector<cln::cl_RA> rationals_;
  std::unordered_map<cln::cl_RA, NodeId, RationalHash> rational_nodes_;
  std::unordered_multimap<std::size_t, NodeId> known_;
  std::uint32_t creation_rank_ = 0;
  std::optional<NodeId> one_ = {};  ///< the coefficient of almost every product
};

/// The nodes that `outputs` need, each once, operands before users.
[[nodiscard]] std::vector<NodeId> reachable_nodes(const Graph& graph,
                                                  const std::vector<SignedNode>& outputs);

/// The number of operand slots and outputs that refer to each node.
[[nodiscard]] std::vector<std::uint32_t> use_counts(const Graph& graph,
                                                    const std::vector<SignedNode>& outputs);

}  // namespace elgen
