// factor and flatten: see factor.hpp. The normal forms of sums and products merge equal terms and
// equal bases.
#include "program/graph/factor.hpp"

#include <algorithm>
#include <map>
#include <optional>

namespace elgen {
namespace {

/// Longer sums are not factored, because the greedy search takes quadratic time.
constexpr std::size_t maximal_terms = 400;

/// A term as a sign and powers, from which common factors are divided out. A rational number is not
/// divisible. Unlike a ScaledTerm, a FactoredTerm has no separate coefficient.
struct FactoredTerm {
  bool is_negative = false;
  std::vector<Power> factors = {};
  bool is_divisible = false;
};

/// Multiplies `term` by factor^exponent. Each base occurs once, so divide() changes one exponent.
void multiply(FactoredTerm& term, NodeId factor, std::int32_t exponent) {
  const auto known = std::find_if(term.factors.begin(), term.factors.end(),
                                  [&](const Power& power) { return power.base.node == factor; });
  if (known == term.factors.end()) {
    term.factors.push_back({{factor, false}, exponent});
  } else {
    known->exponent += exponent;
  }
}

bool has_factor(const FactoredTerm& term, NodeId factor) {
  return term.is_divisible &&
         std::any_of(term.factors.begin(), term.factors.end(), [&](const Power& power) {
           return power.base.node == factor && power.exponent > 0;
         });
}

void divide(FactoredTerm& term, NodeId factor) {
  for (Power& power : term.factors) {
    if (power.base.node == factor) --power.exponent;
  }
  std::erase_if(term.factors, [](const Power& power) { return power.exponent == 0; });
}

class FactorRule {
 public:
  explicit FactorRule(const Expressions& expressions)
      : uses_(use_counts(expressions.graph, expressions.values)) {}

  SignedNode operator()(Graph& graph, const RebuildStep& step) const {
    const Node& node = step.old_graph.node(step.old_node);
    if (node.kind != NodeKind::sum || node.operands.size() > maximal_terms) {
      return copy_node(graph, step);
    }
    std::vector<FactoredTerm> terms;
    for (const Operand& operand : node.operands) terms.push_back(make_term(graph, step, operand));
    return factor_terms(graph, std::move(terms));
  }

 private:
  FactoredTerm make_term(const Graph& graph, const RebuildStep& step,
                         const Operand& operand) const {
    const SignedNode value = negate_if(step.renewed[operand.node], operand.weight < 0);
    FactoredTerm result{value.is_negative, {}, true};
    const Node& node = graph.node(value.node);
    if (node.kind == NodeKind::product && uses_[operand.node] == 1) {
      append_factors(graph, step.old_graph, operand.node, node, result);
      return result;
    }
    result.factors = {{{value.node, false}, 1}};
    result.is_divisible = node.kind != NodeKind::rational;
    return result;
  }

  /// Appends the factors of a product to a term. If the product is a coefficient times a product
  /// that is used nowhere else, appends the factors of the inner product.
  void append_factors(const Graph& graph, const Graph& old_graph, NodeId old_node,
                      const Node& product, FactoredTerm& term) const {
    const std::vector<Operand>& old = old_graph.node(old_node).operands;
    const bool is_scaled = product.operands.size() == 2 &&
                           graph.is_rational(product.operands[0].node) && old.size() == 2 &&
                           uses_[old[1].node] == 1;
    for (const Operand& factor : product.operands) {
      const bool is_rest =
          is_scaled && factor.weight == 1 && graph.node(factor.node).kind == NodeKind::product;
      if (!is_rest) {
        multiply(term, factor.node, factor.weight);
        continue;
      }
      for (const Operand& inner : graph.node(factor.node).operands) {
        multiply(term, inner.node, inner.weight);
      }
    }
  }

  /// The factor that most terms have; none if no two terms share a factor.
  static std::optional<NodeId> most_common_factor(const Graph& graph,
                                                  const std::vector<FactoredTerm>& terms) {
    std::map<NodeId, std::size_t> counts;
    for (const FactoredTerm& term : terms) {
      for (const Power& power : term.factors) {
        if (has_factor(term, power.base.node)) ++counts[power.base.node];
      }
    }
    std::optional<NodeId> best;
    for (const auto& [factor, count] : counts) {
      if (count < 2) continue;
      const std::size_t most = best ? counts[*best] : 0;
      if (count > most || (count == most && graph.less(factor, *best))) best = factor;
    }
    return best;
  }

  static SignedNode factor_terms(Graph& graph, std::vector<FactoredTerm> terms) {
    std::vector<SignedNode> finished;
    while (const std::optional<NodeId> common = most_common_factor(graph, terms)) {
      const auto rest = std::stable_partition(
          terms.begin(), terms.end(),
          [&](const FactoredTerm& term) { return has_factor(term, *common); });
      std::vector<FactoredTerm> inner(terms.begin(), rest);
      terms.erase(terms.begin(), rest);
      for (FactoredTerm& term : inner) divide(term, *common);
      terms.push_back(product_term(graph, *common, factor_terms(graph, std::move(inner))));
    }
    for (const FactoredTerm& term : terms) {
      finished.push_back(negate_if(graph.product(term.factors), term.is_negative));
    }
    return graph.sum(finished);
  }

  /// common * inner. The factors of a product `inner` stay separate: other terms may share them.
  static FactoredTerm product_term(Graph& graph, NodeId common, SignedNode inner) {
    FactoredTerm result{inner.is_negative, {{{common, false}, 1}}, true};
    const Node& node = graph.node(inner.node);
    const bool is_product = node.kind == NodeKind::product;
    const std::vector<Operand> factors =
        is_product ? node.operands : std::vector<Operand>{{inner.node, 1}};
    for (const Operand& factor : factors) multiply(result, factor.node, factor.weight);
    return result;
  }

  std::vector<std::uint32_t> uses_;
};

class FlattenRule {
 public:
  FlattenRule(const Expressions& expressions, FlattenedProducts which)
      : uses_(use_counts(expressions.graph, expressions.values)), which_(which) {}

  SignedNode operator()(Graph& graph, const RebuildStep& step) const {
    const NodeKind kind = step.old_graph.node(step.old_node).kind;
    if (kind == NodeKind::sum) return sum(graph, step);
    if (kind == NodeKind::product) return product(graph, step);
    return copy_node(graph, step);
  }

 private:
  /// True if the operands of `operand` move into its user. `operand` and its user must have the
  /// same kind, in the old and in the new graph. `operand` must be used once; with `all_products`,
  /// a product may be used more often.
  bool is_spliced(const Graph& graph, const RebuildStep& step, const Operand& operand) const {
    const NodeKind kind = step.old_graph.node(step.old_node).kind;
    const bool is_wanted = uses_[operand.node] == 1 ||
                           (which_ == FlattenedProducts::all_products && kind == NodeKind::product);
    return is_wanted && step.old_graph.node(operand.node).kind == kind &&
           graph.node(step.renewed[operand.node].node).kind == kind;
  }

  SignedNode sum(Graph& graph, const RebuildStep& step) const {
    std::vector<SignedNode> terms;
    for (const Operand& operand : step.old_graph.node(step.old_node).operands) {
      const SignedNode renewed = negate_if(step.renewed[operand.node], operand.weight < 0);
      if (!is_spliced(graph, step, operand)) {
        terms.push_back(renewed);
        continue;
      }
      for (const Operand& term : graph.node(renewed.node).operands) {
        terms.push_back({term.node, (term.weight < 0) != renewed.is_negative});
      }
    }
    return graph.sum(terms);
  }

  SignedNode product(Graph& graph, const RebuildStep& step) const {
    std::vector<Power> factors;
    bool negative = false;
    for (const Operand& operand : step.old_graph.node(step.old_node).operands) {
      const SignedNode renewed = step.renewed[operand.node];
      const bool is_power = operand.weight != 1 && which_ == FlattenedProducts::used_once;
      if (is_power || !is_spliced(graph, step, operand)) {
        factors.push_back({renewed, operand.weight});
        continue;
      }
      negative = negative != (renewed.is_negative && operand.weight % 2 != 0);
      for (const Operand& factor : graph.node(renewed.node).operands) {
        factors.push_back({{factor.node, false}, factor.weight * operand.weight});
      }
    }
    return negate_if(graph.product(factors), negative);
  }

  std::vector<std::uint32_t> uses_;
  FlattenedProducts which_;
};

}  // namespace

Expressions factor(const Expressions& expressions) {
  return rebuild(expressions, FactorRule(expressions));
}

Expressions flatten(const Expressions& expressions, FlattenedProducts which) {
  return rebuild(expressions, FlattenRule(expressions, which));
}

}  // namespace elgen
