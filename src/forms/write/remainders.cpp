// remainders: see remainders.hpp.
#include "forms/write/remainders.hpp"

#include <algorithm>
#include <cstdlib>
#include <map>
#include <utility>

#include "forms/write/expanded_calls.hpp"
#include "forms/write/graph_terms.hpp"
#include "forms/write/kept_terms.hpp"

namespace elgen {
namespace {

/// u = at + the sum of slopes[i] d_i + the sum of coefficient * kernel over `remainder`. `at`, the
/// slopes and the coefficients contain no coordinate of the place.
struct LocalExpansion {
  SignedNode value = {};
  SignedNode at = {};
  std::vector<SignedNode> slopes = {};  ///< by coordinate
  SignedNode difference = {};           ///< value - at
  /// Kernel -> coefficient; none if the remainder is unknown.
  std::optional<std::map<NodeId, SignedNode>> remainder = {};
  /// log(u/u0) of coordinates, exponentials and products.
  std::optional<SignedNode> log_ratio = {};
};

/// The arithmetic of expansions.
class LocalArithmetic : protected GraphTermBuilder {
 public:
  LocalArithmetic(Graph& graph, std::size_t coordinates, DifferenceForm difference)
      : GraphTermBuilder(graph),
        coordinates_(coordinates),
        difference_(difference),
        zero_(graph.rational(0)) {}

  using Kernels = std::map<NodeId, SignedNode>;

  [[nodiscard]] bool is_zero(SignedNode x) const { return graph_.is_zero(x.node); }

  [[nodiscard]] bool is_flat(const LocalExpansion& u) const {
    return std::ranges::all_of(u.slopes, [this](SignedNode slope) { return is_zero(slope); });
  }

  [[nodiscard]] std::vector<SignedNode> no_slopes() const {
    return std::vector<SignedNode>(coordinates_, zero_);
  }

  LocalExpansion constant(SignedNode value) {
    return {value, value, no_slopes(), zero_, Kernels{}, zero_};
  }

  void add_kernel(Kernels& kernels, SignedNode coefficient, SignedNode kernel) {
    if (is_zero(kernel)) return;
    const ScaledTerm term = split_term(kernel);
    const SignedNode plain = product(1, term.factors);
    SignedNode& known = kernels.try_emplace(plain.node, zero_).first->second;
    const SignedNode scale =
        graph_.rational(plain.is_negative ? -term.coefficient : term.coefficient);
    known = expanded_sum({known, multiply(coefficient, scale)});
    if (is_zero(known)) kernels.erase(plain.node);
  }

  void add_kernels(Kernels& kernels, SignedNode coefficient, const Kernels& more) {
    for (const auto& [kernel, scale] : more)
      add_kernel(kernels, multiply(coefficient, scale), {kernel, false});
  }

  SignedNode value_of(const Kernels& kernels) {
    std::vector<SignedNode> terms;
    for (const auto& [kernel, coefficient] : kernels)
      terms.push_back(multiply(coefficient, {kernel, false}));
    return graph_.sum(terms);
  }

  /// u itself, as its difference if u0 = 0.
  [[nodiscard]] SignedNode own_value(const LocalExpansion& u) const {
    return is_zero(u.at) ? u.difference : u.value;
  }

  /// Sets an unknown remainder to the difference if all slopes are 0.
  void settle(LocalExpansion& u) {
    if (u.remainder || !is_flat(u)) return;
    u.remainder = Kernels{};
    add_kernel(*u.remainder, one(), u.difference);
  }

  LocalExpansion add(const std::vector<LocalExpansion>& parts) {
    LocalExpansion total = constant(zero_);
    total.log_ratio.reset();
    std::vector<SignedNode> values;
    std::vector<SignedNode> differences;
    std::vector<SignedNode> at;
    for (const LocalExpansion& part : parts) {
      values.push_back(part.value);
      at.push_back(part.at);
      differences.push_back(part.difference);
      if (!part.remainder) total.remainder.reset();
      if (total.remainder) add_kernels(*total.remainder, one(), *part.remainder);
      for (std::size_t i = 0; i < coordinates_; ++i)
        total.slopes[i] = expanded_sum({total.slopes[i], part.slopes[i]});
    }
    total.value = graph_.sum(values);
    total.at = expanded_sum(at);
    total.difference = graph_.sum(differences);
    if (total.remainder && is_flat(total)) total.difference = value_of(*total.remainder);
    settle(total);
    if (difference_ == DifferenceForm::ratio && is_zero(total.at) && !is_flat(total)) {
      const auto better = difference_by_ratio(parts);
      if (better) total.difference = *better;
      has_ratio_ = has_ratio_ || better;
    }
    return total;
  }

  /// log(u/u0) from D(u)/u0, for u0 other than 0.
  SignedNode log_ratio_of(const LocalExpansion& u) {
    return logarithm_near_one(graph_, {}, divide(u.value, u.at), divide(u.difference, u.at));
  }

  /// u - v = (u + v) tanh((log(u/u0) - log(v/v0))/2) for u0 = v0; none unless there are two terms,
  /// both not constant. No digit is lost far from the place if u and v decay.
  std::optional<SignedNode> difference_by_ratio(const std::vector<LocalExpansion>& parts) {
    if (parts.size() != 2 || is_zero(parts[0].at)) return std::nullopt;
    std::vector<SignedNode> ratios;
    for (const LocalExpansion& u : parts) {
      if (is_zero(u.difference)) return std::nullopt;
      ratios.push_back(u.log_ratio ? *u.log_ratio : log_ratio_of(u));
    }
    const SignedNode exponent = half(graph_.sum({ratios[0], -ratios[1]}));
    return multiply(graph_.sum({parts[0].value, -parts[1].value}),
                    call(FunctionId::tanh, exponent));
  }

  LocalExpansion product_of(const LocalExpansion& u, const LocalExpansion& v) {
    LocalExpansion result = constant(multiply(u.value, v.value));
    result.at = expanded_sum({multiply(u.at, v.at)});
    for (std::size_t i = 0; i < coordinates_; ++i)
      result.slopes[i] = expanded_sum({multiply(u.at, v.slopes[i]), multiply(v.at, u.slopes[i])});
    const bool has_log_ratio = u.log_ratio && v.log_ratio;
    result.log_ratio.reset();
    if (has_log_ratio) result.log_ratio = graph_.sum({*u.log_ratio, *v.log_ratio});
    const bool is_square = u.value == v.value;
    result.difference =
        is_square
            ? multiply(u.difference, graph_.sum({own_value(u), u.at}))
            : graph_.sum({multiply(u.difference, own_value(v)), multiply(u.at, v.difference)});
    if (!u.remainder || !v.remainder) {
      result.remainder.reset();
      settle(result);
      return result;
    }
    if (is_flat(u) && !is_flat(v)) return product_of(v, u);
    const bool is_second_flat = is_flat(v);
    if (!is_second_flat) add_kernels(*result.remainder, u.at, *v.remainder);
    add_kernels(*result.remainder, v.at, *u.remainder);
    add_kernel(*result.remainder, one(),
               multiply(is_second_flat ? own_value(u) : u.difference, v.difference));
    return result;
  }

  std::optional<LocalExpansion> reciprocal(const LocalExpansion& u) {
    if (is_zero(u.at)) return std::nullopt;
    const SignedNode inverse = divide(one(), u.at);
    const ExpandedCall call{
        .at = inverse,
        .slope = -square(inverse),
        .difference = -multiply(inverse, divide(u.difference, u.value)),
        .excess = multiply(square(inverse), divide(square(u.difference), u.value))};
    LocalExpansion result = composed(u, divide(one(), u.value), call);
    if (u.log_ratio) result.log_ratio = -*u.log_ratio;
    return result;
  }

  /// f(u): its remainder is f'(u0) R(u) + the excess of the call.
  LocalExpansion composed(const LocalExpansion& u, SignedNode value, const ExpandedCall& call) {
    LocalExpansion result = constant(value);
    result.at = call.at;
    result.difference = call.difference;
    result.log_ratio.reset();
    for (std::size_t i = 0; i < coordinates_; ++i)
      result.slopes[i] = expanded_sum({multiply(call.slope, u.slopes[i])});
    const bool is_known = u.remainder && call.excess && !is_flat(result);
    if (is_known) {
      add_kernels(*result.remainder, call.slope, *u.remainder);
      add_kernel(*result.remainder, one(), *call.excess);
    } else {
      result.remainder.reset();
      settle(result);
    }
    return result;
  }

  LocalExpansion power_of(const LocalExpansion& u, std::int32_t exponent) {
    if (exponent == 1) return u;
    if (exponent % 2 != 0) return product_of(power_of(u, exponent - 1), u);
    const LocalExpansion half = power_of(u, exponent / 2);
    return product_of(half, half);
  }

  /// True if a difference was written as a ratio.
  [[nodiscard]] bool has_ratio() const { return has_ratio_; }

 private:
  std::size_t coordinates_;
  DifferenceForm difference_;
  bool has_ratio_ = false;
  SignedNode zero_;
};

/// Expands the nodes of a graph.
class PlaceExpander : LocalArithmetic {
 public:
  using LocalArithmetic::has_ratio;

  PlaceExpander(Graph& graph, const ExactPlace& place, const LeafNames& leaves,
                DifferenceForm difference)
      : LocalArithmetic(graph, place.size(), difference), place_(place), leaves_(leaves) {}

  /// A sum or a logarithm that vanishes at the place, written without cancellation; none for other
  /// values. Terms whose values at the place are unknown are taken from `renewed`.
  std::optional<SignedNode> rewrite(SignedNode value, const std::map<NodeId, SignedNode>& renewed) {
    const Node& node = graph_.node(value.node);
    const bool is_sum = node.kind == NodeKind::sum;
    if (!is_sum && !is_call(node, FunctionId::log)) return std::nullopt;
    std::vector<LocalExpansion> parts;
    std::vector<SignedNode> terms;
    for (const SignedNode term :
         is_sum ? terms_of(value.node) : std::vector{SignedNode{value.node}}) {
      std::optional<LocalExpansion> part = expand(term);
      if (part) {
        parts.push_back(std::move(*part));
      } else {
        const auto known = renewed.find(term.node);
        terms.push_back(known == renewed.end() ? term : negate_if(known->second, term.is_negative));
      }
    }
    if (parts.empty()) return std::nullopt;
    const LocalExpansion total = add(parts);
    if (!is_zero(total.at)) return std::nullopt;
    terms.push_back(total.difference);
    const SignedNode better = graph_.sum(terms);
    if (better.node == value.node) return std::nullopt;
    return negate_if(better, value.is_negative);
  }

 private:
  std::optional<LocalExpansion> expand(SignedNode value) {
    auto known = known_.find(value.node);
    if (known == known_.end()) {
      std::optional<LocalExpansion> expansion = expand_node(value.node);
      known = known_.emplace(value.node, std::move(expansion)).first;
    }
    if (!known->second || !value.is_negative) return known->second;
    return product_of(*known->second, constant(-one()));
  }

  std::optional<LocalExpansion> expand_node(NodeId id) {
    const Node node = graph_.node(id);
    switch (node.kind) {
      case NodeKind::rational:
      case NodeKind::pi:
        return constant({id, false});
      case NodeKind::leaf:
        return expand_leaf(id, node);
      case NodeKind::sum:
        return expand_sum(node);
      case NodeKind::product:
        return expand_product(id);
      case NodeKind::square_root:
        return expand_root({id, false}, expand(argument_of(node)));
      case NodeKind::call:
        return expand_call(id, node);
    }
    return std::nullopt;
  }

  std::optional<LocalExpansion> expand_leaf(NodeId id, const Node& leaf) {
    if (leaf_row(leaf.leaf).is_zero_at_rest) return std::nullopt;
    const SignedNode value{id, false};
    if (leaf.leaf != Opcode::coordinate || !place_[leaf.index]) return constant(value);
    LocalExpansion result = constant(value);
    const ExactValue& exact = *place_[leaf.index];
    std::vector<SignedNode> terms{
        graph_.rational(exact.number),
        graph_.product({{graph_.rational(exact.half_turns)}, {graph_.pi()}})};
    for (const ScaledParameter& p : exact.parameters)
      terms.push_back(
          graph_.product({{graph_.rational(p.scale)}, {graph_.leaf(Opcode::parameter, p.index)}}));
    result.at = graph_.sum(terms);
    result.slopes[leaf.index] = one();
    // One term after the other, because q - p is exact if q is near p, but p + r is rounded.
    result.difference = value;
    for (const SignedNode term : terms) result.difference = graph_.sum({result.difference, -term});
    result.log_ratio.reset();
    if (!is_zero(result.at)) result.log_ratio = log_ratio_of(result);
    return result;
  }

  std::optional<LocalExpansion> expand_sum(const Node& node) {
    std::vector<LocalExpansion> parts;
    for (const Operand& operand : node.operands) {
      std::optional<LocalExpansion> part = expand({operand.node, operand.weight < 0});
      if (!part) return std::nullopt;
      parts.push_back(std::move(*part));
    }
    return add(parts);
  }

  /// Nested products are flattened: the remainder of 1/r^6 as a power of 1/r stays small far from
  /// the place.
  std::optional<LocalExpansion> expand_product(NodeId id) {
    const ScaledTerm term = split_term({id, false});
    LocalExpansion result = constant(graph_.rational(term.coefficient));
    for (const Operand& operand : term.factors) {
      std::optional<LocalExpansion> factor = expand({operand.node, false});
      if (factor && operand.weight < 0) factor = reciprocal(*factor);
      if (!factor) return std::nullopt;
      result = product_of(result, power_of(*factor, std::abs(operand.weight)));
    }
    return result;
  }

  std::optional<LocalExpansion> expand_root(SignedNode root,
                                            const std::optional<LocalExpansion>& u) {
    if (!u || is_zero(u->at)) return std::nullopt;
    const SignedNode at = positive_root(graph_, leaves_, u->at);
    const SignedNode slope = divide(half(one()), at);
    const SignedNode difference = divide(u->difference, graph_.sum({root, at}));
    LocalExpansion result =
        composed(*u, root, {at, slope, difference, -multiply(slope, square(difference))});
    if (u->log_ratio) result.log_ratio = half(*u->log_ratio);
    return result;
  }

  std::optional<LocalExpansion> expand_call(NodeId id, const Node& node) {
    const SignedNode value{id, false};
    std::vector<LocalExpansion> arguments;
    for (const Operand& operand : node.operands) {
      std::optional<LocalExpansion> argument = expand({operand.node, operand.weight < 0});
      if (!argument) return std::nullopt;
      arguments.push_back(std::move(*argument));
    }
    const auto is_constant = [this](const LocalExpansion& x) { return is_zero(x.difference); };
    if (std::ranges::all_of(arguments, is_constant)) {
      LocalExpansion result = constant(value);
      std::vector<SignedNode> at;
      for (const LocalExpansion& argument : arguments) at.push_back(argument.at);
      result.at = graph_.call(node.function, at);  // without nested products
      return result;
    }
    const LocalExpansion& u = arguments.front();
    if (node.function == FunctionId::hypot) {
      const LocalExpansion& v = arguments.back();
      return expand_root(value, add({product_of(u, u), product_of(v, v)}));
    }
    const std::optional<ExpandedCall> expansion =
        expanded_call(graph_, node.function, {u.value, u.at, u.difference});
    if (!expansion) return std::nullopt;
    LocalExpansion result = composed(u, value, *expansion);
    if (node.function == FunctionId::exp) result.log_ratio = u.difference;
    return result;
  }

  const ExactPlace& place_;
  const LeafNames& leaves_;
  std::map<NodeId, std::optional<LocalExpansion>> known_ = {};
};

}  // namespace

std::optional<Expressions> rewrite_at_place(const Expressions& expressions, const ExactPlace& place,
                                            const LeafNames& leaves, DifferenceForm difference) {
  bool is_rewritten = false;
  std::optional<PlaceExpander> expander;
  std::vector<SignedNode> originals(expressions.graph.size());
  std::map<NodeId, SignedNode> renewed;  // results for the nodes of `originals`
  const auto rule = [&](Graph& graph, const RebuildStep& step) {
    if (!expander) expander.emplace(graph, place, leaves, difference);
    SignedNode& original = originals[step.old_node];
    original = copy_node(graph, {step.old_graph, step.old_node, originals});
    const std::optional<SignedNode> better = expander->rewrite(original, renewed);
    is_rewritten = is_rewritten || better;
    const SignedNode result = better ? *better : copy_node(graph, step);
    renewed[original.node] = negate_if(result, original.is_negative);
    return result;
  };
  Expressions result = rebuild(expressions, rule);
  const bool is_same = difference == DifferenceForm::ratio && !(expander && expander->has_ratio());
  if (!is_rewritten || is_same) return std::nullopt;
  return result;
}

}  // namespace elgen
