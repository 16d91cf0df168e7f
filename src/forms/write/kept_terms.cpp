// kept_terms: see kept_terms.hpp; sums of powers are in square_free.cpp. A pair of terms is
// first tried as a crank, a^2 - b^2 sin(c)^2, then by rows of digit_rows.def, then as quotients.
#include "forms/write/kept_terms.hpp"

#include <algorithm>
#include <cstdlib>
#include <optional>

#include "forms/write/digit_rows.hpp"

namespace elgen {
namespace {

using cln::cl_RA;

class TriangleRewriter : GraphTermBuilder {
 public:
  TriangleRewriter(Graph& graph, RewriteOptions keeping)
      : GraphTermBuilder(graph), keeping_(keeping) {}

  /// Replaces three terms that form a triangle by one term; false if there is no triangle.
  bool replace_one(std::vector<SignedNode>& terms) {
    std::vector<ScaledTerm> parts;
    for (const SignedNode term : terms) parts.push_back(split_term(term));
    std::vector<std::uint64_t> keys;
    for (const ScaledTerm& part : parts) keys.push_back(key_of(part.factors));
    for (std::size_t k = 0; k < terms.size(); ++k) {
      ScaledTerm mixed = parts[k];
      const auto cosine = std::ranges::find_if(mixed.factors, [&](const Operand& factor) {
        return factor.weight == 1 && is_call(graph_.node(factor.node), FunctionId::cos);
      });
      if (cosine == mixed.factors.end()) continue;
      const SignedNode angle = argument_of(graph_.node(cosine->node));
      mixed.factors.erase(cosine);
      const std::uint64_t key = 2 * key_of(mixed.factors);
      for (std::size_t i = 0; i < terms.size(); ++i) {
        for (std::size_t j = i + 1; j < terms.size(); ++j) {
          if (i == k || j == k || keys[i] + keys[j] != key) continue;
          if (!may_be_triangle(parts[i], parts[j], mixed)) continue;
          const std::optional<SignedNode> triangle =
              combine_triangle(parts[i], parts[j], mixed, angle);
          if (!triangle) continue;
          terms[k] = *triangle;
          terms.erase(terms.begin() + static_cast<std::ptrdiff_t>(j));
          terms.erase(terms.begin() + static_cast<std::ptrdiff_t>(i));
          return true;
        }
      }
    }
    return false;
  }

 private:
  /// The key of a product is the sum of the keys of its factors. The keys of C a^2 and C b^2
  /// therefore add up to twice the key of C a b, which rules out most triples of a long sum. Keys
  /// contain cubes of node numbers, because sums of cubes seldom agree by chance.
  static std::uint64_t key_of(const std::vector<Operand>& factors) {
    std::uint64_t key = 0;
    for (const auto& [node, weight] : factors) {
      const std::uint64_t number = node;
      key += number * number * number * static_cast<std::uint64_t>(std::int64_t{weight});
    }
    return key;
  }

  /// True if the coefficients can be the coefficients of C a^2, C b^2 and ±2 C a b.
  static bool may_be_triangle(const ScaledTerm& first, const ScaledTerm& second,
                              const ScaledTerm& mixed) {
    return first.coefficient * second.coefficient * 4 == mixed.coefficient * mixed.coefficient;
  }

  /// C a^2 + C b^2 + `mixed` cos(c) as one term; none unless `mixed` is -2 C a b or +2 C a b. For
  /// +2 C a b, the sine and the cosine of c/2 are exchanged.
  std::optional<SignedNode> combine_triangle(ScaledTerm first, ScaledTerm second,
                                             const ScaledTerm& mixed, SignedNode angle) {
    const cl_RA common = first.coefficient;
    const cl_RA ratio = second.coefficient / common;
    const std::vector<Operand> shared = extract_common_factors(first, second);
    const std::optional<SignedNode> a = exact_root({1, first.factors}, 2);
    const std::optional<SignedNode> b = exact_root({ratio, second.factors}, 2);
    if (!a || !b) return std::nullopt;
    const SignedNode scale = product(common, shared);
    const SignedNode both = multiply(*a, *b);
    const SignedNode twice = multiply(scale, multiply_by_two(both));
    const SignedNode own = product(mixed);
    if (own.node != twice.node) return std::nullopt;
    const bool is_difference = own.is_negative != twice.is_negative;
    const SignedNode sine = square(call(FunctionId::sin, half(angle)));
    const SignedNode cosine = square(call(FunctionId::cos, half(angle)));
    const SignedNode less = square(graph_.sum({*a, -*b}));
    if (keeping_.squares == SquareHandling::factored) {
      const SignedNode more = square(graph_.sum({*a, *b}));
      const SignedNode near = is_difference ? less : more;
      const SignedNode far = is_difference ? more : less;
      return multiply(scale, graph_.sum({multiply(near, cosine), multiply(far, sine)}));
    }
    const SignedNode turn =
        multiply(multiply(graph_.rational(4), both), is_difference ? sine : cosine);
    return multiply(scale, graph_.sum({less, turn}));
  }

  RewriteOptions keeping_;
};

/// A term as a quotient; all exponents are positive.
struct TermQuotient {
  ScaledTerm top = {};
  ScaledTerm bottom = {};
};

/// Rewrites the sum of two terms of a sum.
class PairRewriter : GraphTermBuilder {
 public:
  PairRewriter(Graph& graph, RewriteOptions keeping, bool is_alone)
      : GraphTermBuilder(graph), keeping_(keeping), is_whole_sum_(is_alone) {}

  std::optional<SignedNode> operator()(ScaledTerm x, ScaledTerm y) {
    std::vector<Operand> shared = extract_common_factors(x, y);
    move_shared_divisors(x, y, shared);
    move_shared_divisors(y, x, shared);
    const SignedNode common = product(x.coefficient, shared);
    y.coefficient = y.coefficient / x.coefficient;
    x.coefficient = 1;
    std::optional<SignedNode> better;
    const bool may_be_crank = is_whole_sum_ && keeping_.squares == SquareHandling::factored;
    if (may_be_crank) better = rewrite_crank(x, y);
    if (!better && may_be_crank) better = rewrite_crank(y, x);
    if (!better) better = rewrite_pair_by_rule(graph_, keeping_, x, y);
    if (!better) better = combine_quotients(x, y);
    return better ? std::optional(multiply(common, *better)) : std::nullopt;
  }

 private:
  /// a^2 - b^2 sin(c)^2 = (a - b) (a + b) + b^2 cos(c)^2, for a crank b and a rod a. Sine and
  /// cosine may be exchanged.
  std::optional<SignedNode> rewrite_crank(const ScaledTerm& x, ScaledTerm y) {
    const auto sinusoid = std::ranges::find_if(y.factors, [&](const Operand& factor) {
      return factor.weight == 2 && is_sine_or_cosine(graph_.node(factor.node));
    });
    if (sinusoid == y.factors.end()) return std::nullopt;
    const Node call = graph_.node(sinusoid->node);
    y.factors.erase(sinusoid);
    y.coefficient = -y.coefficient;
    const std::optional<SignedNode> a = exact_root(x, 2);
    const std::optional<SignedNode> b = exact_root(y, 2);
    if (!a || !b) return std::nullopt;
    const bool is_sine = call.function == FunctionId::sin;
    const SignedNode other =
        graph_.call(is_sine ? FunctionId::cos : FunctionId::sin, {argument_of(call)});
    const SignedNode less = multiply(graph_.sum({*a, -*b}), graph_.sum({*a, *b}));
    return graph_.sum({less, multiply(square(*b), square(other))});
  }

  /// Moves the divisors of x that are factors of y to `shared`: a - b/a^2 = (a^3 - b)/a^2.
  static void move_shared_divisors(ScaledTerm& x, ScaledTerm& y, std::vector<Operand>& shared) {
    for (Operand& divisor : x.factors) {
      const auto factor = std::ranges::find(y.factors, divisor.node, &Operand::node);
      if (divisor.weight > 0 || factor == y.factors.end()) continue;
      shared.push_back(divisor);
      factor->weight -= divisor.weight;
      divisor.weight = 0;
    }
    std::erase_if(x.factors, [](const Operand& factor) { return factor.weight == 0; });
  }

  /// a/b - c/d = (a d - b c)/(b d), if this is shorter, or if the pair is 1/b - 1/d or 1 - a/b. The
  /// numerator is rewritten by rewrite_sum().
  std::optional<SignedNode> combine_quotients(const ScaledTerm& x, const ScaledTerm& y) {
    const TermQuotient first = split_quotient(x);
    const TermQuotient second = split_quotient(y);
    const bool is_first_whole = first.bottom.factors.empty();
    const bool is_second_whole = second.bottom.factors.empty();
    if (is_first_whole && is_second_whole) return std::nullopt;
    const bool has_one = x.factors.empty() || y.factors.empty();
    const bool are_inverses = first.top.factors.empty() && second.top.factors.empty();
    const bool is_known =
        has_one ? cln::minusp(y.coefficient) : are_inverses && y.coefficient == -1;
    const bool may_meet =
        !is_first_whole && !is_second_whole &&
        (has_bracket(product(first.bottom)) || has_bracket(product(second.bottom)));
    if (!is_known && !may_meet) return std::nullopt;
    const SignedNode left = short_sum({multiply(product(first.top), product(second.bottom))});
    const SignedNode right = short_sum({multiply(product(second.top), product(first.bottom))});
    const SignedNode top = short_sum({left, right});
    if (!is_known && term_count(top) >= term_count(left) + term_count(right)) return std::nullopt;
    ScaledTerm divisors = first.bottom;
    divisors.factors.insert(divisors.factors.end(), second.bottom.factors.begin(),
                            second.bottom.factors.end());
    for (Operand& divisor : divisors.factors) divisor.weight = -divisor.weight;
    return multiply(rewrite_sum(graph_, keeping_, top).value_or(top), product(divisors));
  }

  static TermQuotient split_quotient(const ScaledTerm& term) {
    TermQuotient ratio{{term.coefficient, {}}, {}};
    for (const auto& [id, weight] : term.factors) {
      ScaledTerm& side = weight > 0 ? ratio.top : ratio.bottom;
      side.factors.push_back({id, std::abs(weight)});
    }
    return ratio;
  }

  RewriteOptions keeping_;
  bool is_whole_sum_;
};

}  // namespace

bool replace_triangle(Graph& graph, RewriteOptions keeping, std::vector<SignedNode>& terms) {
  return TriangleRewriter(graph, keeping).replace_one(terms);
}

std::optional<SignedNode> rewrite_pair(Graph& graph, RewriteOptions keeping,
                                       const std::vector<ScaledTerm>& terms, std::size_t first,
                                       std::size_t second) {
  return PairRewriter(graph, keeping, terms.size() == 2)(terms[first], terms[second]);
}

}  // namespace elgen
