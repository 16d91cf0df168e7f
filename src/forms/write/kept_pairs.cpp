// kept_pairs: see kept_terms.hpp. Rows of digit_rows.def are looked for between cranks and
// quotients.
#include <algorithm>
#include <cstdlib>
#include <optional>

#include "forms/write/digit_rows.hpp"
#include "forms/write/kept_terms.hpp"

namespace elgen {
namespace {

/// A term as a quotient.
struct Ratio {
  ScaledTerm top = {};
  ScaledTerm bottom = {};
};

/// One pair, in the graph that it stands in.
class KeptPair : GraphTerms {
 public:
  KeptPair(Graph& graph, Keeping keeping, bool is_alone)
      : GraphTerms(graph), keeping_(keeping), is_alone_(is_alone) {}

  std::optional<Ref> operator()(ScaledTerm x, ScaledTerm y) {
    std::vector<Operand> shared = take_shared(x, y);
    take_divisors(x, y, shared);
    take_divisors(y, x, shared);
    const Ref common = product(x.coefficient, shared);
    y.coefficient = y.coefficient / x.coefficient;
    x.coefficient = 1;
    std::optional<Ref> better;
    const bool may_be_crank = is_alone_ && keeping_.squares == Squares::apart;
    if (may_be_crank) better = crank(x, y);
    if (!better && may_be_crank) better = crank(y, x);
    if (!better) better = pair_by_row(graph_, keeping_, x, y);
    if (!better) better = quotients(x, y);
    return better ? std::optional(times(common, *better)) : std::nullopt;
  }

 private:
  /// a^2 - b^2 sin(c)^2 = (a - b) (a + b) + b^2 cos(c)^2, of a crank b and a rod a, and with sine
  /// and cosine exchanged.
  std::optional<Ref> crank(const ScaledTerm& x, ScaledTerm y) {
    const auto sinusoid = std::ranges::find_if(y.factors, [&](const Operand& factor) {
      return factor.weight == 2 && is_sine_or_cosine(graph_.node(factor.node));
    });
    if (sinusoid == y.factors.end()) return std::nullopt;
    const Node call = graph_.node(sinusoid->node);
    y.factors.erase(sinusoid);
    y.coefficient = -y.coefficient;
    const std::optional<Ref> a = exact_root(x, 2);
    const std::optional<Ref> b = exact_root(y, 2);
    if (!a || !b) return std::nullopt;
    const bool is_sine = call.function == FunctionId::sin;
    const Ref other = graph_.call(is_sine ? FunctionId::cos : FunctionId::sin, {argument_of(call)});
    const Ref less = times(graph_.sum({*a, -*b}), graph_.sum({*a, *b}));
    return graph_.sum({less, times(square(*b), square(other))});
  }

  /// The divisors of a term that the other multiplies by: a - b/a^2 = (a^3 - b)/a^2.
  static void take_divisors(ScaledTerm& x, ScaledTerm& y, std::vector<Operand>& shared) {
    for (Operand& divisor : x.factors) {
      const auto factor = std::ranges::find(y.factors, divisor.node, &Operand::node);
      if (divisor.weight > 0 || factor == y.factors.end()) continue;
      shared.push_back(divisor);
      factor->weight -= divisor.weight;
      divisor.weight = 0;
    }
    std::erase_if(x.factors, [](const Operand& factor) { return factor.weight == 0; });
  }

  /// a/b - c/d = (a d - b c)/(b d) where that is shorter, and 1/b - 1/d and 1 - a/b; the numerator
  /// is kept in its turn.
  std::optional<Ref> quotients(const ScaledTerm& x, const ScaledTerm& y) {
    const Ratio first = ratio_of(x);
    const Ratio second = ratio_of(y);
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
    const Ref left = short_sum({times(product(first.top), product(second.bottom))});
    const Ref right = short_sum({times(product(second.top), product(first.bottom))});
    const Ref top = short_sum({left, right});
    if (!is_known && term_count(top) >= term_count(left) + term_count(right)) return std::nullopt;
    ScaledTerm divisors = first.bottom;
    divisors.factors.insert(divisors.factors.end(), second.bottom.factors.begin(),
                            second.bottom.factors.end());
    for (Operand& divisor : divisors.factors) divisor.weight = -divisor.weight;
    return times(kept_sum(graph_, keeping_, top).value_or(top), product(divisors));
  }

  static Ratio ratio_of(const ScaledTerm& term) {
    Ratio ratio{{term.coefficient, {}}, {}};
    for (const auto& [id, weight] : term.factors) {
      ScaledTerm& side = weight > 0 ? ratio.top : ratio.bottom;
      side.factors.push_back({id, std::abs(weight)});
    }
    return ratio;
  }

  Keeping keeping_;
  bool is_alone_;
};

}  // namespace

std::optional<Ref> kept_pair(Graph& graph, Keeping keeping, const std::vector<ScaledTerm>& terms,
                             std::size_t first, std::size_t second) {
  return KeptPair(graph, keeping, terms.size() == 2)(terms[first], terms[second]);
}

}  // namespace elgen
