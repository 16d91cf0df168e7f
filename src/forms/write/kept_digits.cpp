// kept_digits: see kept_digits.hpp. Rows of digit_rows.def come first; what they cannot say
// follows: triangles, conjugates of roots, differences of quotients, logarithms.
#include "forms/write/kept_digits.hpp"

#include <algorithm>
#include <cstdlib>
#include <utility>
#include <vector>

#include "forms/write/digit_rows.hpp"
#include "forms/write/graph_terms.hpp"
#include "forms/write/square_free.hpp"

namespace elgen {
namespace {

using cln::cl_RA;

/// Longer sums are left as they are.
constexpr std::size_t most_terms_in_pairs = 24;

/// C a^2 + C b^2 - 2 C a b cos(c) = C ((a - b)^2 + 4 a b sin(c/2)^2), and where squares are taken
/// apart C ((a - b)^2 cos(c/2)^2 + (a + b)^2 sin(c/2)^2), which has all digits whatever the signs
/// of a and b are.
class Triangles : GraphTerms {
 public:
  Triangles(Graph& graph, Squares squares) : GraphTerms(graph), squares_(squares) {}

  /// Puts three such terms together as one; false where there are none.
  bool replace_one(std::vector<Ref>& terms) {
    std::vector<ScaledTerm> parts;
    for (const Ref term : terms) parts.push_back(scaled(term));
    for (std::size_t k = 0; k < terms.size(); ++k) {
      ScaledTerm mixed = parts[k];
      const auto cosine = std::ranges::find_if(mixed.factors, [&](const Operand& factor) {
        return factor.weight == 1 && is_call(graph_.node(factor.node), FunctionId::cos);
      });
      if (cosine == mixed.factors.end()) continue;
      const Ref angle = argument_of(graph_.node(cosine->node));
      mixed.factors.erase(cosine);
      for (std::size_t i = 0; i < terms.size(); ++i) {
        for (std::size_t j = i + 1; j < terms.size(); ++j) {
          if (i == k || j == k) continue;
          const std::optional<Ref> triangle = of_triangle(parts[i], parts[j], mixed, angle);
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
  /// `mixed` is -+2 C a b: with + it is the cosine of c/2.
  std::optional<Ref> of_triangle(ScaledTerm first, ScaledTerm second, const ScaledTerm& mixed,
                                 Ref angle) {
    const cl_RA common = first.coefficient;
    const cl_RA ratio = second.coefficient / common;
    if (ratio * common * common * 4 != mixed.coefficient * mixed.coefficient) return std::nullopt;
    const std::vector<Operand> shared = take_shared(first, second);
    const std::optional<Ref> a = exact_root({1, first.factors}, 2);
    const std::optional<Ref> b = exact_root({ratio, second.factors}, 2);
    if (!a || !b) return std::nullopt;
    const Ref scale = product(common, shared);
    const Ref both = times(*a, *b);
    const Ref twice = times(scale, doubled(both));
    const Ref own = product(mixed);
    if (own.node != twice.node) return std::nullopt;
    const bool is_difference = own.negative != twice.negative;
    const Ref sine = square(call(FunctionId::sin, half(angle)));
    const Ref cosine = square(call(FunctionId::cos, half(angle)));
    const Ref less = square(graph_.sum({*a, -*b}));
    if (squares_ == Squares::apart) {
      const Ref more = square(graph_.sum({*a, *b}));
      const Ref near = is_difference ? less : more;
      const Ref far = is_difference ? more : less;
      return times(scale, graph_.sum({times(near, cosine), times(far, sine)}));
    }
    const Ref turn = times(times(graph_.rational(4), both), is_difference ? sine : cosine);
    return times(scale, graph_.sum({less, turn}));
  }

  Squares squares_;
};

/// root + rest = (root^2 - rest^2)/(root - rest)
class Conjugates : GraphTerms {
 public:
  Conjugates(Graph& graph, Squares squares) : GraphTerms(graph), squares_(squares) {}

  /// Of terms of which one has a root, where root^2 - rest^2 is shorter than root^2, or has squares
  /// to take apart.
  std::optional<Ref> operator()(const std::vector<Ref>& terms) {
    const auto is_root = [&](Ref term) { return has_root(term); };
    if (std::ranges::count_if(terms, is_root) != 1) return std::nullopt;
    const Ref root = *std::ranges::find_if(terms, is_root);
    std::vector<Ref> others = terms;
    std::erase(others, root);
    return conjugate(root, graph_.sum(others));
  }

 private:
  /// One root, and no other.
  [[nodiscard]] bool has_root(Ref term) const {
    const ScaledTerm factors = scaled(term);
    return 1 == std::ranges::count_if(factors.factors, [&](const Operand& factor) {
             return factor.weight == 1 && graph_.node(factor.node).kind == NodeKind::square_root;
           });
  }

  /// Where the numerator vanishes on one side of a branch, so does the divisor: sqrt(x^2) + x.
  std::optional<Ref> conjugate(Ref root, Ref rest) {
    // Two numbers do not cancel.
    if (graph_.is_rational(rest.node) && rest.negative == root.negative) return std::nullopt;
    Ref raised = square_of_root(root);
    Ref numerator = sum({raised, -square(rest)});
    if (term_count(numerator) >= term_count(raised)) {
      const auto long_raised = written_out({raised});
      const auto long_numerator = written_out({raised, -square(rest)});
      if (!long_raised || !long_numerator) return std::nullopt;
      raised = graph_.sum(*long_raised);
      numerator = graph_.sum(*long_numerator);
      if (long_numerator->size() >= long_raised->size()) {
        const auto better =
            squares_ == Squares::apart ? kept_sum(graph_, squares_, numerator) : std::nullopt;
        if (!better) return std::nullopt;
        numerator = *better;
      }
    }
    if (term_count(numerator) == 0 || has_branches(numerator)) return std::nullopt;
    if (!is_anchored(raised)) return std::nullopt;
    return quotient(numerator, sum({root, -rest}));
  }

  /// (C sqrt(a + b))^2 = C^2 a + C^2 b
  Ref square_of_root(Ref root) {
    ScaledTerm term = scaled(root);
    std::vector<Power> shared{{graph_.rational(term.coefficient), 2}};
    Ref radicand = one();
    for (const Operand& factor : term.factors) {
      const Node node = graph_.node(factor.node);
      if (factor.weight == 1 && node.kind == NodeKind::square_root) {
        radicand = argument_of(node);
      } else {
        shared.push_back({{factor.node, false}, 2 * factor.weight});
      }
    }
    const Ref common = graph_.product(shared);
    if (graph_.node(radicand.node).kind != NodeKind::sum) return times(common, radicand);
    std::vector<Ref> terms;
    for (const Ref part : terms_of(radicand.node)) {
      terms.push_back(times(common, with_sign(part, radicand.negative)));
    }
    return graph_.sum(terms);
  }

  Squares squares_;
};

/// A term as a quotient.
struct Ratio {
  ScaledTerm top = {};
  ScaledTerm bottom = {};
};

/// One sum or call, in the graph that it stands in.
class KeptSum : GraphTerms {
 public:
  KeptSum(Graph& graph, Squares squares) : GraphTerms(graph), squares_(squares) {}

  std::optional<Ref> kept(Ref value) {
    if (graph_.node(value.node).kind != NodeKind::sum) return std::nullopt;
    const std::vector<Ref> terms = terms_of(value.node);
    const auto is_bracket = [&](Ref term) { return has_bracket(term); };
    const bool is_hidden = std::ranges::any_of(terms, is_bracket);
    std::optional<Ref> better;
    if (!is_hidden) better = square_free(graph_, squares_, terms);
    if (!better) better = kept_terms(terms);
    if (!better) better = Conjugates(graph_, squares_)(terms);
    if (!better && is_hidden) better = written_out_terms(terms);
    return better ? std::optional(with_sign(*better, value.negative)) : std::nullopt;
  }

  /// log(1 + x) = log1p(x), log(a/b) = log1p((a - b)/b), and log(a) where a - 1 is kept.
  std::optional<Ref> logarithm(Ref argument) {
    if (const auto difference = difference_of_logarithms(argument)) return difference;
    const Ref less = sum({argument, -one()});
    if (has_one(argument)) return call(FunctionId::log1p, less);
    if (graph_.node(less.node).kind != NodeKind::sum) return std::nullopt;
    if (const auto better = kept(less)) return call(FunctionId::log1p, *better);
    const ScaledTerm term = scaled(argument);
    const auto divisor = std::ranges::find(term.factors, -1, &Operand::weight);
    if (term.factors.size() < 2 || divisor == term.factors.end()) return std::nullopt;
    const Ref b{divisor->node, false};
    return call(FunctionId::log1p, quotient(sum({times(argument, b), -b}), b));
  }

 private:
  /// log(a/b) = log(a) - log(b), where a + b is a positive number: both are positive.
  std::optional<Ref> difference_of_logarithms(Ref argument) {
    const ScaledTerm term = scaled(argument);
    if (term.coefficient != 1 || term.factors.size() != 2) return std::nullopt;
    const bool is_first = term.factors[0].weight == 1;
    const Operand& top = term.factors[is_first ? 0 : 1];
    const Operand& bottom = term.factors[is_first ? 1 : 0];
    const Ref a{top.node, false};
    const Ref b{bottom.node, false};
    const Ref both = sum({a, b});
    const bool is_positive = graph_.is_rational(both.node) && !both.negative;
    if (top.weight != 1 || bottom.weight != -1 || !is_positive) return std::nullopt;
    const Ref log_a = logarithm(a).value_or(call(FunctionId::log, a));
    return graph_.sum({log_a, -logarithm(b).value_or(call(FunctionId::log, b))});
  }

  /// Where brackets hide what cancels: (l + x)^2 - l^2 = 2 l x + x^2.
  std::optional<Ref> written_out_terms(const std::vector<Ref>& terms) {
    const auto all = written_out(terms);
    if (!all) return std::nullopt;
    std::optional<Ref> better = square_free(graph_, squares_, *all);
    if (!better) better = kept_terms(*all);
    if (!better && all->size() <= terms.size()) better = graph_.sum(*all);
    return better;
  }

  std::optional<Ref> kept_terms(std::vector<Ref> terms) {
    const auto is_zero = [this](Ref term) { return graph_.is_zero(term.node); };
    bool is_changed = false;
    while (terms.size() > 1 && terms.size() <= most_terms_in_pairs && replace_some(terms)) {
      is_changed = true;
      std::erase_if(terms, is_zero);  // sin(a)^2 - (1 - cos(a)^2), of which one was rewritten
    }
    return is_changed ? std::optional(graph_.sum(terms)) : std::nullopt;
  }

  bool replace_some(std::vector<Ref>& terms) {
    if (Triangles(graph_, squares_).replace_one(terms)) return true;
    if (replace_by_row(graph_, squares_, terms)) return true;
    std::vector<ScaledTerm> parts;
    for (const Ref term : terms) parts.push_back(scaled(term));
    for (std::size_t i = 0; i < terms.size(); ++i) {
      for (std::size_t k = i + 1; k < terms.size(); ++k) {
        if (is_plain(parts[i]) && is_plain(parts[k])) continue;
        std::optional<Ref> better = pair(parts[i], parts[k]);
        if (!better) better = Conjugates(graph_, squares_)({terms[i], terms[k]});
        if (!better) continue;
        terms[i] = *better;
        terms.erase(terms.begin() + static_cast<std::ptrdiff_t>(k));
        return true;
      }
    }
    return false;
  }

  /// Without roots, divisors and powers that are taken apart.
  [[nodiscard]] bool is_plain(const ScaledTerm& term) const {
    return std::ranges::all_of(term.factors, [&](const Operand& factor) {
      const bool is_power = squares_ == Squares::apart && factor.weight > 1;
      const bool is_root = graph_.node(factor.node).kind == NodeKind::square_root;
      return factor.weight > 0 && !is_power && !is_root;
    });
  }

  std::optional<Ref> pair(ScaledTerm x, ScaledTerm y) {
    std::vector<Operand> shared = take_shared(x, y);
    take_divisors(x, y, shared);
    take_divisors(y, x, shared);
    const Ref common = product(x.coefficient, shared);
    y.coefficient = y.coefficient / x.coefficient;
    x.coefficient = 1;
    std::optional<Ref> better;
    if (squares_ == Squares::apart) better = crank(x, y);
    if (!better && squares_ == Squares::apart) better = crank(y, x);
    if (!better) better = pair_by_row(graph_, squares_, x, y);
    if (!better) better = quotients(x, y);
    return better ? std::optional(times(common, *better)) : std::nullopt;
  }

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
    return times(kept(top).value_or(top), product(divisors));
  }

  static Ratio ratio_of(const ScaledTerm& term) {
    Ratio ratio{{term.coefficient, {}}, {}};
    for (const auto& [id, weight] : term.factors) {
      ScaledTerm& side = weight > 0 ? ratio.top : ratio.bottom;
      side.factors.push_back({id, std::abs(weight)});
    }
    return ratio;
  }

  Squares squares_;
};

Ref kept(Graph& graph, const RebuildStep& step, Squares squares, bool& has_any) {
  const Ref same = copy(graph, step);
  const Node& node = graph.node(same.node);
  std::optional<Ref> better;
  if (is_call(node, FunctionId::log)) {
    better = KeptSum(graph, squares).logarithm(argument_of(node));
  } else if (node.kind == NodeKind::call) {
    better = call_by_row(graph, squares, same.node);
  } else {
    better = kept_sum(graph, squares, {same.node, false});
  }
  if (!better) return same;
  has_any = true;
  return with_sign(*better, same.negative);
}

}  // namespace

std::optional<Ref> kept_sum(Graph& graph, Squares squares, Ref value) {
  return KeptSum(graph, squares).kept(value);
}

std::optional<Expressions> with_kept_digits(const Expressions& expressions, Squares squares) {
  bool has_any = false;
  const auto rule = [&](Graph& graph, const RebuildStep& step) {
    return kept(graph, step, squares, has_any);
  };
  Expressions result = rebuild(expressions, rule);
  if (!has_any) return std::nullopt;
  return result;
}

}  // namespace elgen
