// graph_terms: see graph_terms.hpp.
#include "forms/write/graph_terms.hpp"

#include <algorithm>

namespace elgen {

using cln::cl_RA;

bool is_same(const ScaledTerm& x, const ScaledTerm& y) {
  return x.coefficient == y.coefficient && x.factors.size() == y.factors.size() &&
         std::ranges::all_of(x.factors, [&y](const Operand& factor) {
           return std::ranges::find(y.factors, factor) != y.factors.end();
         });
}

Ref GraphTerms::times(Ref x, Ref y) {
  ScaledTerm term = scaled(x);
  const ScaledTerm other = scaled(y);
  term.factors.insert(term.factors.end(), other.factors.begin(), other.factors.end());
  return product(term.coefficient * other.coefficient, term.factors);
}

Ref GraphTerms::sum(const std::vector<Ref>& values) { return graph_.sum(parts_of(values)); }

std::vector<Ref> GraphTerms::parts_of(const std::vector<Ref>& values) {
  std::vector<Ref> parts;
  for (const Ref value : values) {
    for (const Ref part : parts_of(value)) parts.push_back(part);
  }
  return parts;
}

/// Like scaled(), but a sum is a single factor.
ScaledTerm GraphTerms::as_factors(Ref value) const {
  if (graph_.node(value.node).kind != NodeKind::sum) return scaled(value);
  return {value.negative ? -1 : 1, {{value.node, 1}}};
}

std::vector<Operand>::iterator GraphTerms::first_bracket(ScaledTerm& term,
                                                         std::int32_t highest_power) const {
  return std::ranges::find_if(term.factors, [&](const Operand& factor) {
    return 0 < factor.weight && factor.weight <= highest_power &&
           graph_.node(factor.node).kind == NodeKind::sum;
  });
}

std::vector<Ref> GraphTerms::parts_of(Ref value) {
  ScaledTerm term = as_factors(value);
  const auto bracket = first_bracket(term, 1);
  if (bracket == term.factors.end()) return {value};
  const std::vector<Ref> terms = terms_of(bracket->node);
  term.factors.erase(bracket);
  const Ref common = product(term);
  std::vector<Ref> parts;
  for (const Ref part : terms) parts.push_back(times(common, part));
  return parts;
}

void GraphTerms::append_expanded(Ref value, std::size_t most, std::vector<Ref>& terms) {
  if (terms.size() > most) return;
  ScaledTerm term = as_factors(value);
  const auto bracket = first_bracket(term, 2);
  if (bracket == term.factors.end()) return terms.push_back(value);
  const std::vector<Ref> parts = terms_of(bracket->node);
  if (--bracket->weight == 0) term.factors.erase(bracket);
  const Ref common = product(term);
  for (const Ref part : parts) append_expanded(times(common, part), most, terms);
}

std::optional<std::vector<Ref>> GraphTerms::expanded_terms(const std::vector<Ref>& values,
                                                           std::size_t most) {
  std::vector<Ref> terms;
  for (const Ref value : values) append_expanded(value, most, terms);
  if (terms.size() > most) return std::nullopt;
  return parts_of(graph_.sum(terms));
}

Ref GraphTerms::short_sum(const std::vector<Ref>& values) {
  const Ref plain = sum(values);
  const std::vector<Ref> parts = parts_of(plain);
  if (std::ranges::none_of(parts, [&](Ref part) { return has_bracket(part); })) return plain;
  const auto terms = expanded_terms({plain});
  return terms && terms->size() <= parts.size() ? graph_.sum(*terms) : plain;
}

std::vector<Ref> GraphTerms::terms_of(NodeId sum) const {
  std::vector<Ref> terms;
  for (const Operand& operand : graph_.node(sum).operands) {
    const bool is_sum = graph_.node(operand.node).kind == NodeKind::sum;
    const std::vector<Ref> parts =
        is_sum ? terms_of(operand.node) : std::vector<Ref>{{operand.node, false}};
    for (const Ref part : parts) terms.push_back(with_sign(part, operand.weight < 0));
  }
  return terms;
}

std::size_t GraphTerms::term_count(Ref value) const {
  const Node& node = graph_.node(value.node);
  if (graph_.is_rational(value.node) && graph_.is_zero(value.node)) return 0;
  return node.kind == NodeKind::sum ? node.operands.size() : 1;
}

bool GraphTerms::has_bracket(Ref value) const {
  ScaledTerm term = as_factors(value);
  return first_bracket(term, 2) != term.factors.end();
}

bool GraphTerms::has_term_one(Ref value) const {
  const Node& node = graph_.node(value.node);
  if (node.kind != NodeKind::sum) return false;
  return std::ranges::any_of(node.operands, [&](const Operand& term) {
    const bool is_negative = (term.weight < 0) != value.negative;
    return !is_negative && graph_.is_rational(term.node) && graph_.rational_of(term.node) == 1;
  });
}

ScaledTerm GraphTerms::scaled(Ref value) const {
  ScaledTerm term;
  if (value.negative) term.coefficient = -term.coefficient;
  append_power(term, value.node, 1);
  return term;
}

void GraphTerms::append_power(ScaledTerm& term, NodeId base, std::int32_t exponent) const {
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

std::vector<Operand> GraphTerms::take_shared(ScaledTerm& x, ScaledTerm& y) {
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

std::optional<Ref> GraphTerms::exact_root(ScaledTerm term, std::int32_t degree) {
  const bool is_negative = cln::minusp(term.coefficient);
  if (is_negative && degree % 2 == 0) return std::nullopt;
  cl_RA root = 0;
  if (!cln::rootp(cln::abs(term.coefficient), cln::cl_I(degree), &root)) return std::nullopt;
  for (Operand& factor : term.factors) {
    if (factor.weight % degree != 0) return std::nullopt;
    factor.weight /= degree;
  }
  return with_sign(product(root, term.factors), is_negative);
}

Ref GraphTerms::product(const cl_RA& coefficient, const std::vector<Operand>& factors) {
  std::vector<Power> powers{{graph_.rational(coefficient), 1}};
  for (const Operand& factor : factors) powers.push_back({{factor.node, false}, factor.weight});
  return graph_.product(powers);
}

bool GraphTerms::has_parameter_term(Ref value) const {
  const std::vector<Ref> terms = graph_.node(value.node).kind == NodeKind::sum
                                     ? terms_of(value.node)
                                     : std::vector<Ref>{value};
  return std::ranges::any_of(terms, [&](Ref term) {
    return std::ranges::all_of(reachable(graph_, {term}), [&](NodeId id) {
      const Node& node = graph_.node(id);
      return node.kind != NodeKind::leaf || node.leaf == Opcode::parameter;
    });
  });
}

bool GraphTerms::has_branches(Ref value) const {
  return std::ranges::any_of(reachable(graph_, {value}), [&](NodeId id) {
    const Node& node = graph_.node(id);
    if (node.kind == NodeKind::square_root) return !graph_.is_constant(id);
    return node.kind == NodeKind::call &&
           function_row(node.function).smoothness == Smoothness::branches;
  });
}

}  // namespace elgen
