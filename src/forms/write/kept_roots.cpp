// kept_roots: see kept_terms.hpp. Sums of square roots, rewritten by conjugates.
#include <algorithm>
#include <cstddef>
#include <iterator>
#include <optional>
#include <vector>

#include "forms/write/kept_terms.hpp"

namespace elgen {
namespace {

/// Roots that cancel together are sought in sums of up to this many terms, because every triple of
/// terms is tried.
constexpr std::size_t most_terms_with_roots = 8;
/// The squares of two roots of five terms, and of a rest of five terms, have 25 terms each.
constexpr std::size_t most_product_terms = 50;
/// The numerator of combined roots is longer if the roots do not vanish together.
constexpr std::size_t most_numerator_terms = 3;

class ConjugateRewriter : GraphTermBuilder {
 public:
  ConjugateRewriter(Graph& graph, RewriteOptions keeping)
      : GraphTermBuilder(graph), keeping_(keeping) {}

  /// Rewrites a sum in which exactly one term is a product with `roots` roots.
  std::optional<SignedNode> rewrite(const std::vector<SignedNode>& terms, std::ptrdiff_t roots) {
    const auto has_roots = [&](SignedNode term) { return count_roots(term) == roots; };
    if (std::ranges::count_if(terms, has_roots) != 1) return std::nullopt;
    const SignedNode root = *std::ranges::find_if(terms, has_roots);
    std::vector<SignedNode> others = terms;
    std::erase(others, root);
    return rewrite_by_square(root, graph_.sum(others));
  }

  /// Replaces two roots u and v of the same sign and a term w of the other sign.
  bool replace_triple(std::vector<SignedNode>& terms) {
    for (std::size_t i = 0; i < terms.size(); ++i) {
      for (std::size_t j = 0; j < terms.size(); ++j) {
        const bool are_roots = i != j && count_roots(terms[i]) == 1 && count_roots(terms[j]) == 1;
        if (!are_roots || terms[i].is_negative != terms[j].is_negative) continue;
        for (std::size_t k = 0; k < terms.size(); ++k) {
          if (terms[k].is_negative == terms[i].is_negative) continue;
          const auto better = i < j ? combine_triple(terms[i], terms[j], terms[k]) : std::nullopt;
          if (!better && !share_constant(terms[i], terms[k])) continue;
          if (!better) return true;
          terms[i] = *better;
          terms.erase(terms.begin() + static_cast<std::ptrdiff_t>(std::max(j, k)));
          terms.erase(terms.begin() + static_cast<std::ptrdiff_t>(std::min(j, k)));
          return true;
        }
      }
    }
    return false;
  }

 private:
  /// The number of square roots among the factors of a term.
  [[nodiscard]] std::ptrdiff_t count_roots(SignedNode term) const {
    return std::ranges::count_if(split_term(term).factors,
                                 [&](const Operand& factor) { return is_root(factor); });
  }

  [[nodiscard]] bool is_root(const Operand& factor) const {
    return factor.weight == 1 && graph_.node(factor.node).kind == NodeKind::square_root;
  }

  /// root + rest = (root^2 - rest^2)/(root - rest). None if the numerator is too long, or if the
  /// numerator and the divisor may vanish together: on one side of a branch, as in sqrt(x^2) + x.
  std::optional<SignedNode> rewrite_by_square(SignedNode root, SignedNode rest) {
    const bool is_product = count_roots(root) > 1;
    if ((is_product || has_only_parameters(rest)) && !may_cancel(root, rest)) return std::nullopt;
    const std::size_t most = is_product ? most_product_terms : most_expanded_terms;
    SignedNode raised = square_of_root(root);
    const SignedNode rest_squared = multiply(rest, rest);
    SignedNode numerator = sum({raised, -rest_squared});
    if (term_count(numerator) >= term_count(raised)) {
      const auto long_raised = expanded_terms({raised}, most);
      const auto long_numerator = expanded_terms({raised, -rest_squared}, most);
      if (!long_raised || !long_numerator) return std::nullopt;
      raised = graph_.sum(*long_raised);
      numerator = graph_.sum(*long_numerator);
      if (long_numerator->size() >= long_raised->size()) {
        const bool may_be_shorter =
            keeping_.squares == SquareHandling::factored || has_branches(numerator);
        const auto better =
            may_be_shorter ? rewrite_sum(graph_, keeping_, numerator) : std::nullopt;
        if (!better) return std::nullopt;
        numerator = *better;
      }
    }
    // A rest of parameters has one sign, so the divisor does not vanish even for nested roots.
    const bool has_sign = has_only_parameters(rest);
    if (term_count(numerator) == 0 || (has_branches(numerator) && !has_sign)) return std::nullopt;
    if (!has_parameter_term(raised) && !has_parameter_term(rest) && !are_means(root, raised, rest))
      return std::nullopt;
    return quotient(numerator, sum({root, -rest}));
  }

  /// True if `rest` has a term of parameters with the other sign: most parameters are positive.
  bool may_cancel(SignedNode root, SignedNode rest) {
    return std::ranges::any_of(distribute_products({rest}), [&](SignedNode part) {
      return has_only_parameters(part) && part.is_negative != root.is_negative;
    });
  }

  /// True if rest = a + b and root = -2 sqrt(a b), or both with the other sign. The divisor
  /// (sqrt(a) + sqrt(b))^2 vanishes only with a and b. With equal signs it would vanish at a = b.
  bool are_means(SignedNode root, SignedNode raised, SignedNode rest) {
    const std::vector<SignedNode> parts = distribute_products({rest});
    const auto has_sign_of_root = [root](SignedNode part) {
      return part.is_negative == root.is_negative;
    };
    if (parts.size() != 2 || std::ranges::any_of(parts, has_sign_of_root)) return false;
    const SignedNode means = multiply(graph_.rational(4), multiply(parts[0], parts[1]));
    return are_equal_terms(split_term(means), split_term(raised));
  }

  /// (C sqrt(a + b))^2 = C^2 a + C^2 b, (C sqrt(a) sqrt(b))^2 = C^2 a b
  SignedNode square_of_root(SignedNode root) {
    const ScaledTerm term = split_term(root);
    std::vector<Power> shared{{graph_.rational(term.coefficient), 2}};
    std::vector<SignedNode> radicands;
    for (const Operand& factor : term.factors) {
      if (is_root(factor)) {
        radicands.push_back(argument_of(graph_.node(factor.node)));
      } else {
        shared.push_back({{factor.node, false}, 2 * factor.weight});
      }
    }
    SignedNode raised = graph_.product(shared);
    for (const SignedNode radicand : radicands) raised = multiply(raised, radicand);
    const bool is_sum =
        radicands.size() == 1 && graph_.node(radicands.front().node).kind == NodeKind::sum;
    return is_sum ? sum({raised}) : raised;
  }

  /// u + v + w for roots u and v, by Heron's formula with d = w^2 - u^2 - v^2. None if the
  /// numerator has many terms, or terms of both signs. If these cancel where w^2 = (u - v)^2, the
  /// quotient is 0/0, as of sqrt(1 + x) + sqrt(1 + 2 x) - 2 at x = 24.
  ///
  ///     u + v + w = (4 u^2 v^2 - d^2)/((u + v - w) (2 u v + d))
  ///     4 u^2 v^2 - d^2 = w^2 (2 u^2 + 2 v^2 - w^2) - (u^2 - v^2)^2
  std::optional<SignedNode> combine_triple(SignedNode u, SignedNode v, SignedNode w) {
    const SignedNode a = square_of_root(u);
    const SignedNode b = square_of_root(v);
    const SignedNode c = multiply(w, w);
    const auto difference = expanded_terms({a, -b});
    const auto excess = expanded_terms({multiply_by_two(a), multiply_by_two(b), -c});
    const auto d = expanded_terms({c, -a, -b});
    if (!difference || !excess || !d) return std::nullopt;
    const SignedNode less = graph_.sum(*difference);
    const auto terms = expanded_terms({multiply(c, graph_.sum(*excess)), -multiply(less, less)});
    if (!terms || terms->size() > most_numerator_terms) return std::nullopt;
    const auto is_negative = [](SignedNode term) { return term.is_negative; };
    const auto negative = std::ranges::count_if(*terms, is_negative);
    if (negative != 0 && negative != std::ssize(*terms)) return std::nullopt;
    const SignedNode numerator = graph_.sum(*terms);
    const SignedNode rest = graph_.sum(*d);
    const bool is_anchored = has_parameter_term(rest) && !has_branches(rest);
    if (term_count(numerator) == 0 || has_branches(numerator) || !is_anchored) return std::nullopt;
    const SignedNode by_roots = quotient(
        rewrite_sum(graph_, keeping_, numerator).value_or(numerator), graph_.sum({u, v, -w}));
    return quotient(by_roots, graph_.sum({multiply_by_two(multiply(u, v)), rest}));
  }

  /// sqrt(c^2 + x) - d = x/(sqrt(c^2 + x) + c) - (d - c) for parameters with d > c. Another root
  /// takes d - c.
  bool share_constant(SignedNode& root, SignedNode& constant) {
    const auto terms = expanded_terms({square_of_root(root)});
    for (const SignedNode term : terms.value_or(std::vector<SignedNode>{})) {
      const auto share = exact_root(split_term(term), 2);
      if (!share || !has_only_parameters(*share)) continue;
      const SignedNode own = negate_if(*share, constant.is_negative);
      const SignedNode left = graph_.sum({constant, -own});
      if (left.is_negative != constant.is_negative || term_count(left) != 1) continue;
      const auto better = rewrite_by_square(root, own);
      if (!better) continue;
      root = *better;
      constant = left;
      return true;
    }
    return false;
  }

  RewriteOptions keeping_;
};

}  // namespace

std::optional<SignedNode> rewrite_by_conjugate(Graph& graph, RewriteOptions keeping,
                                               const std::vector<SignedNode>& terms,
                                               std::ptrdiff_t roots) {
  return ConjugateRewriter(graph, keeping).rewrite(terms, roots);
}

bool replace_roots(Graph& graph, RewriteOptions keeping, std::vector<SignedNode>& terms) {
  if (terms.size() < 3 || terms.size() > most_terms_with_roots) return false;
  return ConjugateRewriter(graph, keeping).replace_triple(terms);
}

}  // namespace elgen
