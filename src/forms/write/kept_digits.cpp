// kept_digits: see kept_digits.hpp. Tries sums of powers, products of roots, triangles, rows of
// digit_rows.def, sums of logarithms, pairs of terms, and conjugates of roots, in
// this order. Calls of log become log1p or asinh.
#include "forms/write/kept_digits.hpp"

#include <algorithm>
#include <set>
#include <utility>
#include <vector>

#include "forms/write/digit_rows.hpp"
#include "forms/write/kept_terms.hpp"

namespace elgen {
namespace {

/// Longer sums are not rewritten in pairs.
constexpr std::size_t most_terms_in_pairs = 24;
/// Sums in a rewriting are rewritten again, up to this depth; (r^6 - s^6)/r^6 needs four levels.
/// Without a limit, sums of quotients may grow forever.
constexpr int max_rewrite_depth = 6;
/// The limit of sums to rewrite, including nested sums. The entries of models/ need at most 340;
/// each takes up to 0.1 ms.
constexpr std::size_t max_rewritten_sums = 600;

/// Rewrites one sum or logarithm in its graph.
class SumRewriter : GraphTermBuilder {
 public:
  SumRewriter(Graph& graph, RewriteOptions keeping) : GraphTermBuilder(graph), keeping_(keeping) {}

  std::optional<SignedNode> rewrite(SignedNode value) {
    if (graph_.node(value.node).kind != NodeKind::sum) return std::nullopt;
    const std::vector<SignedNode> terms = terms_of(value.node);
    const auto is_bracket = [&](SignedNode term) { return has_bracket(term); };
    const bool is_hidden = std::ranges::any_of(terms, is_bracket);
    std::optional<SignedNode> better;
    if (!is_hidden) better = factor_square_free(graph_, keeping_, terms);
    if (!better) better = rewrite_by_conjugate(graph_, keeping_, terms, 2);
    if (!better) better = rewrite_terms(terms);
    if (!better) better = rewrite_by_conjugate(graph_, keeping_, terms, 1);
    if (!better && is_hidden) better = rewrite_triangle(terms);
    if (!better && is_hidden) better = rewrite_expanded_terms(terms);
    return better ? std::optional(negate_if(*better, value.is_negative)) : std::nullopt;
  }

  /// log(1 + x) = log1p(x). If a - 1 can be rewritten, or a is a quotient b/c, for which a - 1 is
  /// (b - c)/c, log(a) becomes logarithm_near_one().
  std::optional<SignedNode> rewrite_logarithm(SignedNode argument) {
    if (const auto difference = split_logarithm(argument)) return difference;
    const SignedNode less = sum({argument, -one()});
    if (has_term_one(argument)) return call(FunctionId::log1p, less);
    if (graph_.node(less.node).kind != NodeKind::sum) return std::nullopt;
    if (const auto better = rewrite(less))
      return logarithm_near_one(graph_, keeping_, argument, *better);
    const ScaledTerm term = split_term(argument);
    const auto divisor = std::ranges::find(term.factors, -1, &Operand::weight);
    if (term.factors.size() < 2 || divisor == term.factors.end()) return std::nullopt;
    const SignedNode b{divisor->node, false};
    return logarithm_near_one(graph_, keeping_, argument,
                              quotient(sum({multiply(argument, b), -b}), b));
  }

 private:
  /// log(a/b) = log(a) - log(b), if a + b is a positive number. a and b are then both positive,
  /// because a/b is positive.
  std::optional<SignedNode> split_logarithm(SignedNode argument) {
    const ScaledTerm term = split_term(argument);
    if (term.coefficient != 1 || term.factors.size() != 2) return std::nullopt;
    const bool is_first = term.factors[0].weight == 1;
    const Operand& top = term.factors[is_first ? 0 : 1];
    const Operand& bottom = term.factors[is_first ? 1 : 0];
    const SignedNode a{top.node, false};
    const SignedNode b{bottom.node, false};
    const SignedNode both = sum({a, b});
    const bool is_positive = graph_.is_rational(both.node) && !both.is_negative;
    if (top.weight != 1 || bottom.weight != -1 || !is_positive) return std::nullopt;
    const SignedNode log_a = rewrite_logarithm(a).value_or(call(FunctionId::log, a));
    return graph_.sum({log_a, -rewrite_logarithm(b).value_or(call(FunctionId::log, b))});
  }

  /// Replaces a triangle (replace_triangle) in the expanded terms; none if there is no triangle.
  /// In this example b is a sum:
  ///
  ///     a (a - 2 b cos(c)) + b^2
  std::optional<SignedNode> rewrite_triangle(const std::vector<SignedNode>& terms) {
    std::vector<SignedNode> all = distribute_products(terms);
    const bool is_found = replace_triangle(graph_, keeping_, all);
    return is_found ? std::optional(graph_.sum(all)) : std::nullopt;
  }

  /// Expands brackets that hide cancelling terms: (l + x)^2 - l^2 = 2 l x + x^2.
  std::optional<SignedNode> rewrite_expanded_terms(const std::vector<SignedNode>& terms) {
    const auto all = expanded_terms(terms);
    if (!all) return std::nullopt;
    std::optional<SignedNode> better = factor_square_free(graph_, keeping_, *all);
    if (!better) better = rewrite_terms(*all);
    if (!better && all->size() <= terms.size()) better = graph_.sum(*all);
    return better;
  }

  std::optional<SignedNode> rewrite_terms(std::vector<SignedNode> terms) {
    const auto is_zero = [this](SignedNode term) { return graph_.is_zero(term.node); };
    bool is_changed = false;
    while (terms.size() > 1 && terms.size() <= most_terms_in_pairs && replace_once(terms)) {
      is_changed = true;
      std::erase_if(terms, is_zero);  // as in sin(a)^2 - (1 - cos(a)^2)
    }
    return is_changed ? std::optional(graph_.sum(terms)) : std::nullopt;
  }

  bool replace_once(std::vector<SignedNode>& terms) {
    if (replace_triangle(graph_, keeping_, terms)) return true;
    if (rewrite_terms_by_rule(graph_, keeping_, terms)) return true;
    if (replace_logarithms(graph_, keeping_, terms)) return true;
    std::vector<ScaledTerm> parts;
    for (const SignedNode term : terms) parts.push_back(split_term(term));
    for (std::size_t i = 0; i < terms.size(); ++i) {
      for (std::size_t k = i + 1; k < terms.size(); ++k) {
        if (is_plain_product(parts[i]) && is_plain_product(parts[k])) continue;
        std::optional<SignedNode> better = rewrite_pair(graph_, keeping_, parts, i, k);
        if (!better) better = rewrite_by_conjugate(graph_, keeping_, {terms[i], terms[k]}, 1);
        if (!better) continue;
        terms[i] = *better;
        terms.erase(terms.begin() + static_cast<std::ptrdiff_t>(k));
        return true;
      }
    }
    return false;
  }

  /// True if the term has no roots, no divisors, and no powers to be factored.
  [[nodiscard]] bool is_plain_product(const ScaledTerm& term) const {
    return std::ranges::all_of(term.factors, [&](const Operand& factor) {
      const bool is_power = keeping_.squares == SquareHandling::factored && factor.weight > 1;
      const bool is_root = graph_.node(factor.node).kind == NodeKind::square_root;
      return factor.weight > 0 && !is_power && !is_root;
    });
  }

  RewriteOptions keeping_;
};

SignedNode rewrite_node(Graph& graph, const RebuildStep& step, RewriteOptions keeping,
                        bool& is_rewritten) {
  const SignedNode same = copy_node(graph, step);
  const Node& node = graph.node(same.node);
  std::optional<SignedNode> better;
  if (is_call(node, FunctionId::log)) {
    better = SumRewriter(graph, keeping).rewrite_logarithm(argument_of(node));
  } else if (node.kind == NodeKind::call) {
    better = rewrite_call_by_rule(graph, keeping, same.node);
  } else {
    better = rewrite_sum(graph, keeping, {same.node, false});
  }
  if (!better) return same;
  is_rewritten = true;
  return negate_if(*better, same.is_negative);
}

/// The calls that can be computed from another call in the same expressions.
std::set<NodeId> replaceable_calls(const Expressions& expressions) {
  Graph graph = expressions.graph;
  const std::vector<NodeId> nodes = reachable_nodes(graph, expressions.values);
  // The sign of a sine's argument does not matter: it can be moved in front of the sine.
  const auto has_call = [&](FunctionId function, SignedNode argument) {
    return std::ranges::any_of(nodes, [&](NodeId id) {
      const Node& node = graph.node(id);
      if (!is_call(node, function)) return false;
      const SignedNode other = argument_of(node);
      return function == FunctionId::sin ? other.node == argument.node : other == argument;
    });
  };
  std::set<NodeId> found;
  for (const NodeId id : nodes) {
    const Node node = graph.node(id);
    if (!is_sine_or_cosine(node) && !is_call(node, FunctionId::exp)) continue;
    const SignedNode argument = argument_of(node);
    const bool is_found = is_sine_or_cosine(node)
                              ? has_call(FunctionId::sin, GraphTermBuilder(graph).half(argument))
                              : has_call(FunctionId::expm1, argument);
    if (is_found) found.insert(id);
  }
  return found;
}

SignedNode express_by_shared_call(Graph& graph, FunctionId function, SignedNode argument) {
  const SignedNode one = graph.rational(1);
  if (function == FunctionId::exp) {
    return graph.sum({one, graph.call(FunctionId::expm1, {argument})});
  }
  const SignedNode half = GraphTermBuilder(graph).half(argument);
  const SignedNode sine = graph.call(FunctionId::sin, {half});
  const SignedNode two = graph.rational(2);
  if (function == FunctionId::cos) return graph.sum({one, -graph.product({{two, 1}, {sine, 2}})});
  return graph.product({{two, 1}, {sine, 1}, {graph.call(FunctionId::cos, {half}), 1}});
}

}  // namespace

std::optional<SignedNode> rewrite_sum(Graph& graph, RewriteOptions options, SignedNode value) {
  if (options.depth == max_rewrite_depth) return std::nullopt;
  if (options.progress != nullptr) {
    if (options.progress->remaining_sums == 0) return std::nullopt;
    --options.progress->remaining_sums;
  }
  ++options.depth;
  return SumRewriter(graph, options).rewrite(value);
}

KeptDigits rewrite_to_keep_digits(const Expressions& expressions, SquareHandling squares) {
  bool has_any = false;
  RewriteProgress progress{max_rewritten_sums};
  const RewriteOptions options{.squares = squares, .progress = &progress};
  const auto rule = [&](Graph& graph, const RebuildStep& step) {
    return rewrite_node(graph, step, options, has_any);
  };
  Expressions result = rebuild(expressions, rule);
  if (progress.remaining_sums == 0) return {.is_limited = true};
  if (!has_any) return {};
  return {std::move(result)};
}

std::optional<Expressions> replace_redundant_calls(const Expressions& expressions) {
  const std::set<NodeId> calls = replaceable_calls(expressions);
  if (calls.empty()) return std::nullopt;
  const auto rule = [&calls](Graph& graph, const RebuildStep& step) {
    if (!calls.contains(step.old_node)) return copy_node(graph, step);
    const Node& node = step.old_graph.node(step.old_node);
    const Operand& argument = node.operands[0];
    const SignedNode renewed = negate_if(step.renewed[argument.node], argument.weight < 0);
    return express_by_shared_call(graph, node.function, renewed);
  };
  return rebuild(expressions, rule);
}

}  // namespace elgen
