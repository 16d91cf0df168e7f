// Quotients that are 0/0 at coordinate 0 become Stumpff functions, which have values there:
//
//     L*(1 - cos(q))/q        ->   L*q*stumpff(q, 2)
//     sin(kappa*L)/kappa      ->   stumpff(kappa*L, 1)*L
//     x + L/q - L/q*cos(q)    ->   x + L*q*stumpff(q, 2)
//
// by sin(a) = a stumpff(a, 1) and X - X cos(a) = X a^2 stumpff(a, 2), with a = c q. The rewriting
// precedes any derivation, since derivatives of these quotients are not recognised. Nodes of the
// arena change in place, so that references stay valid. Model::original_expressions keeps the
// original nodes.
#include <cln/integer.h>

#include <algorithm>
#include <utility>

#include "check/expressions/node_builder.hpp"
#include "check/judge/judge.hpp"
#include "elgen/references.hpp"

namespace elgen {
namespace {

/// base^exponent, or stumpff(base, order)^exponent if the order is not 0.
struct PowerFactor {
  ExpressionId base = 0;
  std::int64_t exponent = 1;
  int order = 0;
};

/// sin(argument); with order 2, `scale` - `scale` cos(argument).
struct VanishingFactor {
  ExpressionId argument = 0;
  int order = 1;
  std::optional<ExpressionId> scale = {};
};

/// The node itself or, for the name of a definition, its expression, through nested definitions.
ExpressionId resolve_definition(const Model& model, ExpressionId id) {
  while (refers_to_entry(model.expressions[id], NamedKind::definition)) {
    id = model.definitions[model.expressions[id].index].value;
  }
  return id;
}

/// True if x and y are one node, or equal leaves or numbers, which the arena does not share.
bool is_same(const Model& model, ExpressionId x, ExpressionId y) {
  const Expression& a = model.expressions[x];
  const Expression& b = model.expressions[y];
  if (a.kind == ExpressionKind::number) return b.kind == a.kind && a.number == b.number;
  return x == y || (a.kind == ExpressionKind::leaf && is_leaf(b, a.leaf) && a.index == b.index &&
                    a.operands.empty());
}

/// A product of powers, with definitions expanded. Long products are not rewritten: expanded
/// definitions may have exponentially many factors.
class PowerProduct {
 public:
  explicit PowerProduct(const Model& model) : model_(model) {}
  PowerProduct(const Model& model, ExpressionId id) : model_(model) { multiply(id, 1); }

  [[nodiscard]] const Model& model() const { return model_; }
  [[nodiscard]] const std::vector<PowerFactor>& factors() const { return factors_; }
  [[nodiscard]] bool is_negative() const { return is_negative_; }
  [[nodiscard]] bool is_long() const { return visits_ > most_visits; }

  /// Coordinates in the denominator.
  [[nodiscard]] std::vector<std::uint32_t> divisor_coordinates() const {
    std::vector<std::uint32_t> result;
    for (const PowerFactor& power : factors_) {
      const Expression& node = model_.expressions[power.base];
      const bool divides = power.order == 0 && power.exponent < 0;
      if (divides && is_leaf(node, Opcode::coordinate)) result.push_back(node.index);
    }
    return result;
  }

  [[nodiscard]] std::int64_t exponent_of(std::uint32_t coordinate) const {
    for (const PowerFactor& power : factors_) {
      const Expression& node = model_.expressions[power.base];
      const bool is_it = is_leaf(node, Opcode::coordinate) && node.index == coordinate;
      if (power.order == 0 && is_it) return power.exponent;
    }
    return 0;
  }

  void multiply(ExpressionId id, std::int64_t exponent) {
    if (++visits_ > most_visits) return;
    id = resolve_definition(model_, id);
    const Expression& node = model_.expressions[id];
    switch (node.kind) {
      case ExpressionKind::number:
        if (cln::abs(node.number) != 1) break;
        is_negative_ = is_negative_ != (node.number < 0 && exponent % 2 != 0);
        return;
      case ExpressionKind::negate:
        is_negative_ = is_negative_ != (exponent % 2 != 0);
        multiply(node.operands[0], exponent);
        return;
      case ExpressionKind::multiply:
        for (const ExpressionId operand : node.operands) multiply(operand, exponent);
        return;
      case ExpressionKind::divide:
        multiply(node.operands[0], exponent);
        multiply(node.operands[1], -exponent);
        return;
      case ExpressionKind::power:
        if (cln::denominator(node.number) != 1) break;
        multiply(node.operands[0], exponent * cln::cl_I_to_long(cln::numerator(node.number)));
        return;
      default:
        break;
    }
    multiply_factor({id, exponent});
  }

  void multiply_factor(const PowerFactor& factor) {
    const auto known = std::ranges::find_if(factors_, [&](const PowerFactor& power) {
      return power.order == factor.order && is_same(model_, power.base, factor.base);
    });
    if (known == factors_.end()) {
      factors_.push_back(factor);
    } else if ((known->exponent += factor.exponent) == 0) {
      factors_.erase(known);
    }
  }

  [[nodiscard]] ExpressionId build_node(NodeBuilder& nodes) const {
    std::vector<ExpressionId> above;
    std::vector<ExpressionId> below;
    for (const auto& [base, exponent, order] : factors_) {
      const std::int64_t size = exponent < 0 ? -exponent : exponent;
      const ExpressionId value = order == 0 ? base : nodes.stumpff(base, order);
      (exponent < 0 ? below : above)
          .push_back(size == 1 ? value : nodes.power(value, cln::cl_I(static_cast<long>(size))));
    }
    ExpressionId result = nodes.multiply(above);
    if (!below.empty()) result = nodes.divide(result, nodes.multiply(below));
    return is_negative_ ? nodes.negate(result) : result;
  }

 private:
  static constexpr std::size_t most_visits = 100;

  const Model& model_;
  std::vector<PowerFactor> factors_ = {};
  bool is_negative_ = false;
  std::size_t visits_ = 0;
};

/// The factor X (1 - cos(a)) if `whole` is X and `part` is -X cos(a); none for other terms.
std::optional<VanishingFactor> find_versine(const Model& model, ExpressionId whole,
                                            ExpressionId part) {
  PowerProduct quotient(model, part);
  quotient.multiply(whole, -1);
  if (quotient.is_long() || !quotient.is_negative() || quotient.factors().size() != 1) return {};
  const auto& [base, exponent, order] = quotient.factors().front();
  const Expression& cosine = model.expressions[base];
  const bool is_cosine = cosine.kind == ExpressionKind::function &&
                         cosine.function == FunctionId::cos && exponent == 1;
  if (!is_cosine) return {};
  return VanishingFactor{cosine.operands[0], 2, whole};
}

std::optional<VanishingFactor> find_vanishing_factor(const Model& model, ExpressionId id) {
  const Expression& node = model.expressions[id];
  if (node.kind == ExpressionKind::function && node.function == FunctionId::sin) {
    return VanishingFactor{node.operands[0]};
  }
  if (node.kind != ExpressionKind::add || node.operands.size() != 2) return std::nullopt;
  const auto factor = find_versine(model, node.operands[0], node.operands[1]);
  return factor ? factor : find_versine(model, node.operands[1], node.operands[0]);
}

/// Multiplies `product` by sin(a) = a stumpff(a, 1) or X - X cos(a) = X a^2 stumpff(a, 2).
void multiply_series(PowerProduct& product, const VanishingFactor& factor) {
  if (factor.scale) product.multiply(*factor.scale, 1);
  product.multiply(factor.argument, factor.order);
  product.multiply_factor({factor.argument, 1, factor.order});
}

/// The node and the parts of a factor sin(a) or X - X cos(a) of `product`, if a is proportional to
/// `coordinate`; none if no factor matches. A factor of the order `wanted` is preferred.
std::optional<std::pair<ExpressionId, VanishingFactor>> find_cancelling_factor(
    const PowerProduct& product, std::uint32_t coordinate, int wanted) {
  std::optional<std::pair<ExpressionId, VanishingFactor>> found;
  for (const auto& [base, exponent, order] : product.factors()) {
    if (order != 0 || exponent <= 0) continue;
    const auto factor = find_vanishing_factor(product.model(), base);
    if (!factor || PowerProduct(product.model(), factor->argument).exponent_of(coordinate) != 1)
      continue;
    if (!found || factor->order == wanted) found = {base, *factor};
  }
  return found;
}

/// Cancels a coordinate in the denominator against factors that vanish if the coordinate is 0. None
/// if a power of the coordinate would remain in the denominator.
std::optional<PowerProduct> cancel_divisor(PowerProduct product, std::uint32_t coordinate) {
  while (product.exponent_of(coordinate) < 0 && !product.is_long()) {
    const int wanted = product.exponent_of(coordinate) < -1 ? 2 : 1;
    const auto factor = find_cancelling_factor(product, coordinate, wanted);
    if (!factor) return std::nullopt;
    product.multiply_factor({factor->first, -1});
    multiply_series(product, factor->second);
  }
  return product.is_long() ? std::nullopt : std::optional(std::move(product));
}

/// The product after cancelling; none if no coordinate cancels.
std::optional<PowerProduct> cancel_divisors(const Model& model, ExpressionId id) {
  std::optional<PowerProduct> result;
  const PowerProduct typed(model, id);
  if (typed.is_long()) return std::nullopt;
  for (const std::uint32_t coordinate : typed.divisor_coordinates()) {
    auto product = cancel_divisor(result.value_or(typed), coordinate);
    if (product) result.emplace(*product);
  }
  return result;
}

/// The sum of the terms X and -X cos(a) as X a^2 stumpff(a, 2). None if `whole` and `part` are
/// other terms, or if a coordinate would remain in the denominator.
std::optional<PowerProduct> merge_pair(const Model& model, ExpressionId whole, ExpressionId part) {
  const auto factor = find_versine(model, whole, part);
  if (!factor) return std::nullopt;
  PowerProduct product(model);
  multiply_series(product, *factor);
  if (product.is_long() || !product.divisor_coordinates().empty()) return std::nullopt;
  return product;
}

/// The sum with each pair X and -X cos(a) merged if both contain 1/q; none if no pair matches. None
/// also for more than `most_quotients` terms with 1/q: the number of comparisons is quadratic.
std::optional<ExpressionId> merge_pairs_of_sum(NodeBuilder& nodes, const Model& model,
                                               ExpressionId id) {
  constexpr std::size_t most_quotients = 100;
  std::vector<ExpressionId> terms = model.expressions[id].operands;
  std::vector<std::size_t> quotients;
  for (std::size_t i = 0; i < terms.size(); ++i) {
    if (!PowerProduct(model, terms[i]).divisor_coordinates().empty()) quotients.push_back(i);
  }
  if (quotients.size() > most_quotients) return std::nullopt;
  bool is_changed = false;
  for (const std::size_t whole : quotients) {
    for (const std::size_t part : quotients) {
      const auto product = merge_pair(model, terms[whole], terms[part]);
      if (!product) continue;
      terms[whole] = product->build_node(nodes);
      terms[part] = no_expression;
      is_changed = true;
    }
  }
  return is_changed ? std::optional(nodes.add(terms)) : std::nullopt;
}

/// A new node with Stumpff functions for a product or a sum; none if nothing changes.
std::optional<ExpressionId> rewrite_with_stumpff(NodeBuilder& nodes, const Model& model,
                                                 ExpressionId id) {
  const ExpressionKind kind = model.expressions[id].kind;
  if (kind == ExpressionKind::add) return merge_pairs_of_sum(nodes, model, id);
  const bool is_product = kind == ExpressionKind::multiply || kind == ExpressionKind::divide ||
                          kind == ExpressionKind::power;
  const auto product = is_product ? cancel_divisors(model, id) : std::nullopt;
  return product ? std::optional(product->build_node(nodes)) : std::nullopt;
}

}  // namespace

void rewrite_quotients(Context& context) {
  Model& model = context.model;
  std::vector<ExpressionId> all = reachable_expressions(model, equation_and_output_roots(model));
  std::ranges::reverse(all);  // a product before its factors
  for (const ExpressionId id : all) {
    NodeBuilder nodes(context, model.expressions[id].span);
    const std::optional<ExpressionId> written = rewrite_with_stumpff(nodes, model, id);
    if (!written) continue;
    model.original_expressions.emplace(id, model.expressions[id]);
    model.expressions[id] = model.expressions[*written];
  }
}

}  // namespace elgen
