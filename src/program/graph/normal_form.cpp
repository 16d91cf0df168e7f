// Graph::sum and Graph::product: the normal forms of n-ary nodes.
//
//     sum:      y - x + 2*x          -> x + y        equal terms merged, leading term positive
//               2*y - 2*x            -> -2*(x - y)   common coefficient of all terms pulled out
//               m*sin(x)^2 + m*cos(x)^2 -> m
//               x + (y - x)          -> y
//     product:  (y - x)*x*(x - y)    -> -x*(x - y)^2 signs pulled out, equal bases merged
//               2*pi*x/4             -> 1/2*pi*x     rational numbers are one coefficient
//               sinh(x)/cosh(x)      -> tanh(x)      the calls overflow, their quotient does not
//               e^x/(1 + e^x)        -> 1/(1 + e^-x)
#include <cln/integer.h>

#include <algorithm>
#include <cstdlib>
#include <optional>
#include <utility>

#include "program/graph/graph.hpp"

namespace elgen {
namespace {

/// Sorts by node and merges parts of the same node.
template <class Part, class Merging>
void merge_by_node(std::vector<Part>& parts, const Merging& merge) {
  std::ranges::sort(parts, {}, &Part::node);
  std::size_t count = 0;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    if (count > 0 && parts[count - 1].node == parts[i].node) {
      merge(parts[count - 1], parts[i]);
    } else {
      parts[count++] = parts[i];
    }
  }
  parts.resize(count);
}

/// Larger multiples k of x in e^(k x)/(1 + e^x) stay; the code would have long powers.
constexpr int max_logistic_power = 4;

}  // namespace

/// A product split into its rational coefficient and powers of other nodes.
struct Graph::Factors {
  cln::cl_RA coefficient = 1;  ///< signed
  std::vector<Operand> powers = {};
};

/// coefficient * node; the node itself has no rational coefficient.
struct Graph::Term {
  cln::cl_RA coefficient = 1;
  NodeId node = 0;
};

void Graph::collect_factors(const Power& power, Factors& factors) {
  const bool is_odd = power.exponent % 2 != 0;
  if (power.base.is_negative && is_odd) factors.coefficient = -factors.coefficient;
  if (is_rational(power.base.node)) {
    const cln::cl_RA value = cln::expt(rational_of(power.base.node), power.exponent);
    factors.coefficient = factors.coefficient * value;
    return;
  }
  // Products inside a constant are spliced, so that equal constants have one form.
  const Node& base = node(power.base.node);
  if (base.kind == NodeKind::product && is_constant(power.base.node)) {
    const std::vector<Operand> operands = base.operands;
    for (const Operand& operand : operands) {
      collect_factors({{operand.node, false}, operand.weight * power.exponent}, factors);
    }
    return;
  }
  // Only the coefficient is pulled out: the scaled product stays one node, because it may be
  // shared.
  if (const std::optional<Term> scaled = scaled_product(power.base.node)) {
    factors.coefficient = factors.coefficient * cln::expt(scaled->coefficient, power.exponent);
    collect_factors({{scaled->node, false}, power.exponent}, factors);
    return;
  }
  factors.powers.push_back({power.base.node, power.exponent});
}

/// Merges equal bases. sqrt(x)^2 becomes x, which may merge with other powers of x.
void Graph::merge_factors(Factors& factors) {
  std::vector<Operand>& powers = factors.powers;
  const auto is_squared = [this](const Operand& power) {
    return node(power.node).kind == NodeKind::square_root && std::abs(power.weight) > 1;
  };
  for (;;) {
    merge_by_node(powers, [](Operand& to, const Operand& from) { to.weight += from.weight; });
    std::erase_if(powers, [](const Operand& power) { return power.weight == 0; });
    if (join_hyperbolic_quotient(powers) || join_logistic_quotient(powers)) continue;
    if (std::ranges::none_of(powers, is_squared)) return;
    for (const Operand& power : std::exchange(powers, {})) {
      const bool is_whole = !is_squared(power);
      if (is_whole || power.weight % 2 != 0) {
        powers.push_back({power.node, is_whole ? power.weight : power.weight % 2});
      }
      if (is_whole) continue;
      const Operand radicand = node(power.node).operands[0];
      collect_factors({{radicand.node, radicand.weight < 0}, power.weight / 2}, factors);
    }
  }
}

/// Replaces powers of sinh(x)/cosh(x), or of the reciprocal, by powers of tanh(x). False if there
/// is no such quotient.
bool Graph::join_hyperbolic_quotient(std::vector<Operand>& powers) {
  for (Operand& sine : powers) {
    if (!is_call(node(sine.node), FunctionId::sinh)) continue;
    const Operand argument = node(sine.node).operands[0];
    const auto cosine = std::ranges::find_if(powers, [&](const Operand& power) {
      return is_call(node(power.node), FunctionId::cosh) &&
             node(power.node).operands[0].node == argument.node;
    });
    if (cosine == powers.end() || (sine.weight > 0) == (cosine->weight > 0)) continue;
    const std::int32_t size = std::min(std::abs(sine.weight), std::abs(cosine->weight));
    const std::int32_t weight = sine.weight > 0 ? size : -size;
    sine.weight -= weight;
    cosine->weight += weight;
    powers.push_back({call(FunctionId::tanh, {{argument.node, false}}).node, weight});
    return true;
  }
  return false;
}

/// The argument x of a sum 1 + e^x; none for any other node.
std::optional<SignedNode> Graph::logistic_argument(NodeId id) const {
  const Node& sum = node(id);
  if (sum.kind != NodeKind::sum || sum.operands.size() != 2) return std::nullopt;
  for (const std::size_t i : {std::size_t{0}, std::size_t{1}}) {
    const auto [one, other] = std::pair(sum.operands[1 - i], sum.operands[i]);
    if (rational_value({one.node, one.weight < 0}) != cln::cl_RA(1) || other.weight < 0) continue;
    if (!is_call(node(other.node), FunctionId::exp)) continue;
    const Operand& argument = node(other.node).operands[0];
    return SignedNode{argument.node, argument.weight < 0};
  }
  return std::nullopt;
}

/// Replaces e^(k x)/(1 + e^x)^n, k a positive integer, by e^((k - m) x) (1 + e^x)^(m - n)
/// (1 + e^-x)^-m with m = min(k, n). False if there is no such quotient.
bool Graph::join_logistic_quotient(std::vector<Operand>& powers) {
  for (std::size_t i = 0; i < powers.size(); ++i) {
    const auto argument = powers[i].weight < 0 ? logistic_argument(powers[i].node) : std::nullopt;
    if (!argument) continue;
    const Term single = split_coefficient(*argument);
    for (std::size_t k = 0; k < powers.size(); ++k) {
      if (powers[k].weight < 0 || !is_call(node(powers[k].node), FunctionId::exp)) continue;
      const Operand exponent = node(powers[k].node).operands[0];
      const Term multiple = split_coefficient({exponent.node, exponent.weight < 0});
      const cln::cl_RA ratio = multiple.coefficient / single.coefficient;
      const bool is_multiple = multiple.node == single.node && cln::denominator(ratio) == 1 &&
                               cln::plusp(ratio) && ratio <= max_logistic_power;
      if (!is_multiple) continue;
      const auto grown = static_cast<std::int32_t>(cln::cl_I_to_long(cln::numerator(ratio)));
      const std::int32_t count = powers[k].weight * grown;
      const std::int32_t joined = std::min(count, -powers[i].weight);
      powers[k].weight = 0;
      powers[i].weight += joined;
      powers.push_back({call(FunctionId::exp, {*argument}).node, count - joined});
      const SignedNode falling = call(FunctionId::exp, {-*argument});
      powers.push_back({sum({rational(1), falling}).node, -joined});
      return true;
    }
  }
  return false;
}

SignedNode Graph::build_product(Factors factors) {
  if (cln::zerop(factors.coefficient)) return rational(0);
  const bool negative = cln::minusp(factors.coefficient);
  const SignedNode coefficient = rational(cln::abs(factors.coefficient));
  if (factors.powers.empty()) return negate_if(coefficient, negative);
  const bool has_coefficient = cln::abs(factors.coefficient) != 1;
  if (!has_coefficient && factors.powers.size() == 1 && factors.powers[0].weight == 1) {
    return {factors.powers[0].node, negative};
  }
  if (has_coefficient) factors.powers.push_back({coefficient.node, 1});
  sort(factors.powers);
  return {intern({.kind = NodeKind::product, .operands = std::move(factors.powers)}), negative};
}

SignedNode Graph::product(const std::vector<Power>& powers) {
  Factors factors;
  factors.powers.reserve(powers.size() + 1);  // + 1: the coefficient
  for (const Power& power : powers) collect_factors(power, factors);
  merge_factors(factors);
  return build_product(std::move(factors));
}

/// c and the product without c, if `id` is a product with a rational coefficient c; otherwise none.
std::optional<Graph::Term> Graph::scaled_product(NodeId id) {
  const Node& product = node(id);
  const bool is_scaled = product.kind == NodeKind::product && is_rational(product.operands[0].node);
  if (!is_scaled) return std::nullopt;
  const cln::cl_RA& coefficient = rational_of(product.operands[0].node);
  if (product.unscaled) return Term{coefficient, *product.unscaled};
  Factors rest;
  rest.powers.assign(product.operands.begin() + 1, product.operands.end());
  const NodeId scaled = build_product(std::move(rest)).node;
  nodes_[id].unscaled = scaled;
  return Term{rational_of(node(id).operands[0].node), scaled};
}

Graph::Term Graph::split_coefficient(SignedNode term) {
  Term result = scaled_product(term.node).value_or(Term{1, term.node});
  if (term.is_negative) result.coefficient = -result.coefficient;
  return result;
}

SignedNode Graph::build_sum(const std::vector<Term>& terms, const cln::cl_RA& constant) {
  const bool has_constant = !cln::zerop(constant);
  if (terms.empty()) return rational(constant);
  const cln::cl_RA first = cln::abs(terms[0].coefficient);
  const bool is_common =
      !has_constant && std::all_of(terms.begin(), terms.end(),
                                   [&](const Term& t) { return cln::abs(t.coefficient) == first; });
  std::vector<Operand> operands;
  operands.reserve(terms.size() + 1);
  for (const Term& term : terms) {
    const cln::cl_RA magnitude = is_common ? cln::cl_RA(1) : cln::abs(term.coefficient);
    const SignedNode factor = rational(magnitude);
    const bool is_itself = magnitude == 1 && !is_constant(term.node);
    const NodeId scaled = is_itself ? term.node : product({{factor}, {{term.node, false}}}).node;
    operands.push_back({scaled, cln::minusp(term.coefficient) ? -1 : 1});
  }
  if (has_constant) {
    operands.push_back({rational(constant).node, cln::minusp(constant) ? -1 : 1});
  }
  sort(operands);
  const bool negative = operands[0].weight < 0;
  if (negative) {
    for (Operand& operand : operands) operand.weight = -operand.weight;
  }
  SignedNode result{operands[0].node, negative};
  if (operands.size() > 1) {
    result.node = intern({.kind = NodeKind::sum, .operands = std::move(operands)});
  }
  return is_common ? product({{rational(first)}, {result}}) : result;
}

/// The index of sin(x)^2 among the factors of a product; the operand count if there is none.
std::size_t Graph::squared_sine_index(NodeId id) const {
  const std::vector<Operand>& factors = node(id).operands;
  if (node(id).kind != NodeKind::product) return factors.size();
  const auto is_squared_sine = [this](const Operand& factor) {
    return factor.weight == 2 && is_call(node(factor.node), FunctionId::sin);
  };
  const auto it = std::find_if(factors.begin(), factors.end(), is_squared_sine);
  return static_cast<std::size_t>(it - factors.begin());
}

/// The chosen terms in the order of the graph.
template <class Choice>
std::vector<Graph::Term*> Graph::sorted_terms(std::vector<Term>& terms,
                                              const Choice& is_chosen) const {
  std::vector<Term*> sorted;
  for (Term& term : terms) {
    if (is_chosen(term.node)) sorted.push_back(&term);
  }
  std::sort(sorted.begin(), sorted.end(),
            [this](const Term* x, const Term* y) { return less(x->node, y->node); });
  return sorted;
}

/// Replaces the first pair f*sin(x)^2 + f*cos(x)^2, in the order of the graph, by f; false if no
/// pair exists. The order is fixed, because another pair could give another sum.
bool Graph::join_squares(std::vector<Term>& terms) {
  const auto has_squared_sine = [this](NodeId id) {
    return squared_sine_index(id) < node(id).operands.size();
  };
  for (Term* term : sorted_terms(terms, has_squared_sine)) {
    const std::size_t position = squared_sine_index(term->node);
    const Operand angle = node(node(term->node).operands[position].node).operands[0];
    std::vector<Power> powers;
    for (const Operand& factor : node(term->node).operands) {
      powers.push_back({{factor.node, false}, factor.weight});
    }
    powers[position].base = call(FunctionId::cos, {{angle.node, false}});
    const NodeId partner = product(powers).node;
    const auto other = std::find_if(terms.begin(), terms.end(), [&](const Term& t) {
      return t.node == partner && t.coefficient == term->coefficient;
    });
    if (other == terms.end()) continue;
    powers.erase(powers.begin() + static_cast<std::ptrdiff_t>(position));
    term->node = product(powers).node;
    terms.erase(other);
    return true;
  }
  return false;
}

void Graph::merge_terms(std::vector<Term>& terms) {
  merge_by_node(terms, [](Term& to, const Term& from) {
    to.coefficient = to.coefficient + from.coefficient;
  });
  std::erase_if(terms, [](const Term& term) { return cln::zerop(term.coefficient); });
}

/// Expands the first sum among the terms that contains the opposite of another term. If the
/// opposite terms did not cancel, the result would contain rounding errors of their size. Returns
/// false if no such sum exists.
bool Graph::expand_opposite_terms(std::vector<Term>& terms) {
  const auto has_opposite = [&terms](const Term& part) {
    return std::any_of(terms.begin(), terms.end(), [&part](const Term& term) {
      return term.node == part.node && cln::zerop(term.coefficient + part.coefficient);
    });
  };
  const auto is_sum = [this](NodeId id) { return node(id).kind == NodeKind::sum; };
  for (Term* sum : sorted_terms(terms, is_sum)) {
    const std::vector<Operand> operands = node(sum->node).operands;
    std::vector<Term> parts;
    for (const Operand& operand : operands) {
      Term part = split_coefficient({operand.node, operand.weight < 0});
      part.coefficient = part.coefficient * sum->coefficient;
      parts.push_back(part);
    }
    if (std::none_of(parts.begin(), parts.end(), has_opposite)) continue;
    terms.erase(terms.begin() + (sum - terms.data()));
    terms.insert(terms.end(), parts.begin(), parts.end());
    return true;
  }
  return false;
}

SignedNode Graph::sum(const std::vector<SignedNode>& terms) {
  cln::cl_RA constant = 0;
  std::vector<Term> split;
  split.reserve(terms.size());
  for (const SignedNode term : terms) {
    if (const auto number = rational_value(term)) {
      constant = constant + *number;
    } else {
      split.push_back(split_coefficient(term));
    }
  }
  merge_terms(split);
  if (!join_squares(split) && !expand_opposite_terms(split)) return build_sum(split, constant);
  std::vector<SignedNode> fewer;
  for (const Term& term : split) {
    fewer.push_back(product({{rational(term.coefficient)}, {{term.node, false}}}));
  }
  fewer.push_back(rational(constant));
  return sum(fewer);
}

}  // namespace elgen
