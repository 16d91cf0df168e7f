// kept_roots: see kept_terms.hpp. Sums of square roots, rewritten by conjugates.
#include <algorithm>
#include <cstddef>
#include <optional>
#include <vector>

#include "forms/write/kept_terms.hpp"

namespace elgen {
namespace {

/// The squares of two roots of five terms, and of a rest of five terms, have 25 terms each.
constexpr std::size_t most_product_terms = 50;

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

  RewriteOptions keeping_;
};

}  // namespace

std::optional<SignedNode> rewrite_by_conjugate(Graph& graph, RewriteOptions keeping,
                                               const std::vector<SignedNode>& terms,
                                               std::ptrdiff_t roots) {
  return ConjugateRewriter(graph, keeping).rewrite(terms, roots);
}

}  // namespace elgen
