// graph_terms: see graph_terms.hpp.
#include "forms/write/graph_terms.hpp"

#include <algorithm>
#include <unordered_set>

namespace elgen {

using cln::cl_RA;

namespace {

/// True if `is_sought` holds for `top` or a node that `top` needs. Visits only these nodes, whereas
/// reachable_nodes() passes over the whole graph, which long rewritings fill with thousands of
/// nodes.
template <class IsSought>
bool contains_node(const Graph& graph, NodeId top, const IsSought& is_sought) {
  std::vector<NodeId> left{top};
  std::unordered_set<NodeId> known{top};
  while (!left.empty()) {
    const NodeId id = left.back();
    left.pop_back();
    if (is_sought(id)) return true;
    for (const Operand& operand : graph.node(id).operands) {
      if (known.insert(operand.node).second) left.push_back(operand.node);
    }
  }
  return false;
}

}  // namespace

bool are_equal_terms(const ScaledTerm& x, const ScaledTerm& y) {
  return x.coefficient == y.coefficient && x.factors.size() == y.factors.size() &&
         std::ranges::all_of(x.factors, [&y](const Operand& factor) {
           return std::ranges::find(y.factors, factor) != y.factors.end();
         });
}

SignedNode GraphTermBuilder::multiply(SignedNode x, SignedNode y) {
  ScaledTerm term = split_term(x);
  const ScaledTerm other = split_term(y);
  term.factors.insert(term.factors.end(), other.factors.begin(), other.factors.end());
  return product(term.coefficient * other.coefficient, term.factors);
}

SignedNode GraphTermBuilder::divide(SignedNode x, SignedNode y) {
  ScaledTerm inverse = split_term(y);
  inverse.coefficient = 1 / inverse.coefficient;
  for (Operand& factor : inverse.factors) factor.weight = -factor.weight;
  return multiply(x, product(inverse));
}

SignedNode GraphTermBuilder::sum(const std::vector<SignedNode>& values) {
  return graph_.sum(distribute_products(values));
}

std::vector<SignedNode> GraphTermBuilder::distribute_products(
    const std::vector<SignedNode>& values) {
  std::vector<SignedNode> parts;
  for (const SignedNode value : values) {
    for (const SignedNode part : parts_of(value)) parts.push_back(part);
  }
  return parts;
}

/// Like split_term(), but a sum is a single factor.
ScaledTerm GraphTermBuilder::split_into_factors(SignedNode value) const {
  if (graph_.node(value.node).kind != NodeKind::sum) return split_term(value);
  return {value.is_negative ? -1 : 1, {{value.node, 1}}};
}

std::vector<Operand>::iterator GraphTermBuilder::find_bracket(ScaledTerm& term,
                                                              std::int32_t highest_power) const {
  return std::ranges::find_if(term.factors, [&](const Operand& factor) {
    return 0 < factor.weight && factor.weight <= highest_power &&
           graph_.node(factor.node).kind == NodeKind::sum;
  });
}

std::vector<SignedNode> GraphTermBuilder::parts_of(SignedNode value) {
  ScaledTerm term = split_into_factors(value);
  const auto bracket = find_bracket(term, 1);
  if (bracket == term.factors.end()) return {value};
  const std::vector<SignedNode> terms = terms_of(bracket->node);
  term.factors.erase(bracket);
  const SignedNode common = product(term);
  std::vector<SignedNode> parts;
  for (const SignedNode part : terms) parts.push_back(multiply(common, part));
  return parts;
}

void GraphTermBuilder::append_expanded_terms(SignedNode value, std::size_t most,
                                             std::vector<SignedNode>& terms) {
  if (terms.size() > most) return;
  ScaledTerm term = split_into_factors(value);
  const auto bracket = find_bracket(term, 2);
  if (bracket == term.factors.end()) return terms.push_back(value);
  const std::vector<SignedNode> parts = terms_of(bracket->node);
  if (--bracket->weight == 0) term.factors.erase(bracket);
  const SignedNode common = product(term);
  for (const SignedNode part : parts) append_expanded_terms(multiply(common, part), most, terms);
}

std::optional<std::vector<SignedNode>> GraphTermBuilder::expanded_terms(
    const std::vector<SignedNode>& values, std::size_t most) {
  std::vector<SignedNode> terms;
  for (const SignedNode value : values) append_expanded_terms(value, most, terms);
  if (terms.size() > most) return std::nullopt;
  return parts_of(graph_.sum(terms));
}

SignedNode GraphTermBuilder::short_sum(const std::vector<SignedNode>& values) {
  const SignedNode plain = sum(values);
  const std::vector<SignedNode> parts = parts_of(plain);
  if (std::ranges::none_of(parts, [&](SignedNode part) { return has_bracket(part); })) return plain;
  const auto terms = expanded_terms({plain});
  return terms && terms->size() <= parts.size() ? graph_.sum(*terms) : plain;
}

std::vector<SignedNode> GraphTermBuilder::terms_of(NodeId sum) const {
  std::vector<SignedNode> terms;
  for (const Operand& operand : graph_.node(sum).operands) {
    const bool is_sum = graph_.node(operand.node).kind == NodeKind::sum;
    const std::vector<SignedNode> parts =
        is_sum ? terms_of(operand.node) : std::vector<SignedNode>{{operand.node, false}};
    for (const SignedNode part : parts) terms.push_back(negate_if(part, operand.weight < 0));
  }
  return terms;
}

std::size_t GraphTermBuilder::term_count(SignedNode value) const {
  const Node& node = graph_.node(value.node);
  if (graph_.is_rational(value.node) && graph_.is_zero(value.node)) return 0;
  return node.kind == NodeKind::sum ? node.operands.size() : 1;
}

bool GraphTermBuilder::has_bracket(SignedNode value) const {
  ScaledTerm term = split_into_factors(value);
  return find_bracket(term, 2) != term.factors.end();
}

bool GraphTermBuilder::has_term_one(SignedNode value) const {
  const Node& node = graph_.node(value.node);
  if (node.kind != NodeKind::sum) return false;
  return std::ranges::any_of(node.operands, [&](const Operand& term) {
    const bool is_negative = (term.weight < 0) != value.is_negative;
    return !is_negative && graph_.is_rational(term.node) && graph_.rational_of(term.node) == 1;
  });
}

ScaledTerm GraphTermBuilder::split_term(SignedNode value) const {
  ScaledTerm term;
  if (value.is_negative) term.coefficient = -term.coefficient;
  append_power(term, value.node, 1);
  std::erase_if(term.factors, [](const Operand& factor) { return factor.weight == 0; });
  return term;
}

void GraphTermBuilder::append_power(ScaledTerm& term, NodeId base, std::int32_t exponent) const {
  const Node& node = graph_.node(base);
  if (node.kind == NodeKind::product) {
    for (const Operand& factor : node.operands) {
      append_power(term, factor.node, exponent * factor.weight);
    }
  } else if (graph_.is_rational(base)) {
    const cl_RA& number = graph_.rational_of(base);
    term.coefficient = term.coefficient * cln::expt(number, cln::cl_I(exponent));
  } else {
    const auto known = std::ranges::find(term.factors, base, &Operand::node);
    if (known == term.factors.end()) return term.factors.push_back({base, exponent});
    known->weight += exponent;
  }
}

std::vector<Operand> GraphTermBuilder::extract_common_factors(ScaledTerm& x, ScaledTerm& y) {
  std::vector<Operand> shared;
  for (Operand& factor : x.factors) {
    const auto other = std::ranges::find(y.factors, factor.node, &Operand::node);
    if (other == y.factors.end()) continue;
    if ((factor.weight > 0) != (other->weight > 0)) continue;
    const std::int32_t both = factor.weight > 0 ? std::min(factor.weight, other->weight)
                                                : std::max(factor.weight, other->weight);
    shared.push_back({factor.node, both});
    factor.weight -= both;
    other->weight -= both;
  }
  const auto is_gone = [](const Operand& factor) { return factor.weight == 0; };
  std::erase_if(x.factors, is_gone);
  std::erase_if(y.factors, is_gone);
  return shared;
}

std::optional<SignedNode> GraphTermBuilder::exact_root(ScaledTerm term, std::int32_t degree) {
  const bool is_negative = cln::minusp(term.coefficient);
  if (is_negative && degree % 2 == 0) return std::nullopt;
  cl_RA root = 0;
  if (!cln::rootp(cln::abs(term.coefficient), cln::cl_I(degree), &root)) return std::nullopt;
  for (Operand& factor : term.factors) {
    if (factor.weight % degree != 0) return std::nullopt;
    factor.weight /= degree;
  }
  return negate_if(product(root, term.factors), is_negative);
}

SignedNode GraphTermBuilder::product(const cl_RA& coefficient,
                                     const std::vector<Operand>& factors) {
  std::vector<Power> powers{{graph_.rational(coefficient), 1}};
  for (const Operand& factor : factors) powers.push_back({{factor.node, false}, factor.weight});
  return graph_.product(powers);
}

bool GraphTermBuilder::has_parameter_term(SignedNode value) const {
  const std::vector<SignedNode> terms = graph_.node(value.node).kind == NodeKind::sum
                                            ? terms_of(value.node)
                                            : std::vector<SignedNode>{value};
  return std::ranges::any_of(terms, [&](SignedNode term) { return has_only_parameters(term); });
}

bool GraphTermBuilder::has_only_parameters(SignedNode value) const {
  return !contains_node(graph_, value.node, [&](NodeId id) {
    const Node& node = graph_.node(id);
    return node.kind == NodeKind::leaf && node.leaf != Opcode::parameter;
  });
}

bool GraphTermBuilder::has_branches(SignedNode value) const {
  return contains_node(graph_, value.node, [&](NodeId id) {
    const Node& node = graph_.node(id);
    if (node.kind == NodeKind::square_root) return !graph_.is_constant(id);
    return node.kind == NodeKind::call &&
           function_row(node.function).smoothness == Smoothness::branches;
  });
}

}  // namespace elgen
