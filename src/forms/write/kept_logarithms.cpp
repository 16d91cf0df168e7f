// kept_logarithms: see kept_terms.hpp. K log(c) is K (c - 1) or K (1 - 1/c) and a remainder without
// cancellation. It is written so if other terms of the sum cancel these linear terms.
#include <algorithm>
#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "forms/write/kept_terms.hpp"

namespace elgen {
namespace {

/// Logarithms near 1, and their remainders.
class LogarithmBuilder : GraphTermBuilder {
 public:
  using GraphTermBuilder::GraphTermBuilder;

  SignedNode near_one(RewriteOptions keeping, SignedNode a, SignedNode less) {
    if (is_nonnegative(less)) return call(FunctionId::log1p, less);
    const SignedNode root = graph_.square_root(a);
    const SignedNode half_logarithm =
        call(FunctionId::asinh, graph_.product({{less, 1}, {root, -1}, {graph_.rational(2), -1}}));
    if (keeping.progress != nullptr) {
      const SignedNode of_call = half_logarithm.is_negative ? quotient(one(), a) : a;
      keeping.progress->logarithms.emplace(half_logarithm.node, of_call);
    }
    return multiply_by_two(half_logarithm);
  }

  SignedNode remainder(const QuotientNearOne& ratio, SignedNode logarithm) {
    const auto& [above, below, b] = ratio;
    const SignedNode w = graph_.square_root(divide(above, below));
    const SignedNode share = graph_.product({{logarithm}, {graph_.sum({one(), w}), -2}});
    const SignedNode series =
        graph_.call(FunctionId::stumpff, {half(logarithm), graph_.rational(-3)});
    const SignedNode sum_of_parts =
        graph_.sum({graph_.product({{b, 2}, {graph_.sum({one(), -share})}}),
                    graph_.product({{half(w)}, {logarithm, 3}, {series}})});
    return divide(multiply(sum_of_parts, below), short_sum({above, below}));
  }

 private:
  /// True if `value` is a positive number times even powers, roots and positive calls, or a sum of
  /// such terms.
  [[nodiscard]] bool is_nonnegative(SignedNode value) const {
    if (graph_.node(value.node).kind == NodeKind::sum) {
      return !value.is_negative &&
             std::ranges::all_of(terms_of(value.node),
                                 [this](SignedNode term) { return is_nonnegative(term); });
    }
    const ScaledTerm term = split_term(value);
    const auto is_factor_nonnegative = [&](const Operand& factor) {
      const Node& base = graph_.node(factor.node);
      const bool is_positive_call =
          base.kind == NodeKind::call &&
          function_row(base.function).smoothness == Smoothness::entire_positive;
      return factor.weight % 2 == 0 || base.kind == NodeKind::square_root || is_positive_call;
    };
    return cln::plusp(term.coefficient) && std::ranges::all_of(term.factors, is_factor_nonnegative);
  }
};

class LogarithmRewriter : GraphTermBuilder {
 public:
  LogarithmRewriter(Graph& graph, RewriteOptions keeping, const std::vector<SignedNode>& terms)
      : GraphTermBuilder(graph), keeping_(keeping) {
    for (const SignedNode term : terms) add_term(term);
  }

  /// The terms with all logarithms rewritten; none if the linear terms do not cancel. `is_inverse`:
  /// the linear terms are K (1 - 1/c). `is_whole`: see split_argument().
  std::optional<std::vector<SignedNode>> rewrite(bool is_inverse, bool is_whole) {
    if (scales_.empty()) return std::nullopt;
    std::vector<SignedNode> linear;
    std::vector<SignedNode> result = others_;
    for (const auto& [call, scale] : scales_) {
      auto [above, below] = split_argument(call, is_whole);
      if (graph_.is_zero(above.node)) return std::nullopt;
      if (is_inverse) std::swap(above, below);
      const SignedNode own = negate_if(scale, is_inverse);
      const SignedNode logarithm = negate_if(value_of(call), is_inverse);
      const SignedNode difference = short_sum({above, -below});
      linear.push_back(divide(multiply(own, difference), below));
      const QuotientNearOne ratio{above, below, divide(difference, below)};
      result.push_back(-multiply(own, logarithm_remainder(graph_, ratio, logarithm)));
    }
    const auto parts = expanded_terms(linear);
    if (!parts) return std::nullopt;
    for (const SignedNode part : *parts) {
      if (graph_.is_zero(part.node)) continue;
      const ScaledTerm opposite = split_term(-part);
      const auto found = std::ranges::find_if(
          result, [&](SignedNode other) { return are_equal_terms(split_term(other), opposite); });
      if (found == result.end()) return std::nullopt;
      result.erase(found);
    }
    return result;
  }

 private:
  void add_term(SignedNode term) {
    ScaledTerm parts = split_term(term);
    const auto found = std::ranges::find_if(parts.factors, [&](const Operand& factor) {
      const Node& node = graph_.node(factor.node);
      return factor.weight == 1 && !graph_.is_constant(factor.node) &&
             (is_call(node, FunctionId::log) || is_call(node, FunctionId::log1p) ||
              half_logarithm_argument(factor.node));
    });
    if (found == parts.factors.end()) return others_.push_back(term);
    const NodeId call = found->node;
    parts.factors.erase(found);
    if (half_logarithm_argument(call)) parts.coefficient = parts.coefficient / 2;
    const auto [known, is_new] = scales_.try_emplace(call, product(parts));
    if (!is_new) known->second = graph_.sum({known->second, product(parts)});
  }

  /// c if `call` is a call of asinh with the value log(c)/2; otherwise none.
  [[nodiscard]] std::optional<SignedNode> half_logarithm_argument(NodeId call) const {
    if (keeping_.progress == nullptr) return std::nullopt;
    const auto found = keeping_.progress->logarithms.find(call);
    return found == keeping_.progress->logarithms.end() ? std::nullopt
                                                        : std::optional(found->second);
  }

  /// The logarithm that `call` computes.
  SignedNode value_of(NodeId call) {
    const SignedNode value{call, false};
    return half_logarithm_argument(call) ? multiply_by_two(value) : value;
  }

  /// c of log(c) or log1p(c - 1) as a dividend and a divisor; as c and 1 if `is_whole`.
  std::pair<SignedNode, SignedNode> split_argument(NodeId call, bool is_whole) {
    const std::optional<SignedNode> known = half_logarithm_argument(call);
    const bool is_log = known || is_call(graph_.node(call), FunctionId::log);
    ScaledTerm top = split_term(known ? *known : argument_of(graph_.node(call)));
    ScaledTerm bottom;
    for (const Operand& factor : top.factors) {
      if (!is_whole && factor.weight < 0) bottom.factors.push_back({factor.node, -factor.weight});
    }
    if (!is_whole) std::erase_if(top.factors, [](const Operand& x) { return x.weight < 0; });
    const SignedNode below = product(bottom);
    return {is_log ? product(top) : short_sum({product(top), below}), below};
  }

  RewriteOptions keeping_;
  std::map<NodeId, SignedNode> scales_ = {};  ///< K of each logarithm
  std::vector<SignedNode> others_ = {};
};

}  // namespace

SignedNode logarithm_near_one(Graph& graph, RewriteOptions keeping, SignedNode a, SignedNode less) {
  return LogarithmBuilder(graph).near_one(keeping, a, less);
}

SignedNode logarithm_remainder(Graph& graph, const QuotientNearOne& ratio, SignedNode logarithm) {
  return LogarithmBuilder(graph).remainder(ratio, logarithm);
}

bool replace_logarithms(Graph& graph, RewriteOptions keeping, std::vector<SignedNode>& terms) {
  LogarithmRewriter rewriter(graph, keeping, terms);
  auto better = rewriter.rewrite(false, false);
  if (!better) better = rewriter.rewrite(true, false);
  if (!better) better = rewriter.rewrite(false, true);
  if (!better) better = rewriter.rewrite(true, true);
  if (better) terms = std::move(*better);
  return better.has_value();
}

}  // namespace elgen
