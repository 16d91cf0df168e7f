// kept_digits: see kept_digits.hpp. A term is a number times powers; two terms of a sum are C f and
// -C g, and f - g is looked up by the kinds of f and g.
#include "forms/write/kept_digits.hpp"

#include <algorithm>
#include <array>
#include <vector>

#include "forms/write/graph_terms.hpp"

namespace elgen {
namespace {

using cln::cl_RA;

/// Longer sums are left as they are.
constexpr std::size_t most_terms_in_pairs = 24;

/// f(a) - f(b) = ±2 g((a + b)/2) h((a - b)/2)
struct DifferenceOfCalls {
  FunctionId function;
  FunctionId of_mean;
  FunctionId of_half;
  bool is_negative = false;
};

constexpr std::array differences_of_calls{
    DifferenceOfCalls{FunctionId::sin, FunctionId::cos, FunctionId::sin},
    DifferenceOfCalls{FunctionId::cos, FunctionId::sin, FunctionId::sin, true},
    DifferenceOfCalls{FunctionId::sinh, FunctionId::cosh, FunctionId::sinh},
    DifferenceOfCalls{FunctionId::cosh, FunctionId::sinh, FunctionId::sinh},
    DifferenceOfCalls{FunctionId::exp, FunctionId::exp, FunctionId::sinh}};

/// The one factor of a term beside what another term shares; `one` where nothing is left.
struct Rest {
  enum class Kind : std::uint8_t { one, call, root, inverse, square, other } kind = Kind::other;
  FunctionId function = FunctionId::sin;
  Ref value = {};     ///< the term itself
  Ref argument = {};  ///< of a call, the radicand, what is inverted or squared
};

/// a^2 + b^2 - 2 a b cos(c) = (a - b)^2 + 4 a b sin(c/2)^2
class Triangles : GraphTerms {
 public:
  using GraphTerms::GraphTerms;

  /// Puts three such terms together as one; false where there are none.
  bool replace_one(std::vector<Ref>& terms) {
    for (std::size_t k = 0; k < terms.size(); ++k) {
      ScaledTerm mixed = scaled(terms[k]);
      const auto cosine = std::ranges::find_if(mixed.factors, [&](const Operand& factor) {
        return factor.weight == 1 && is_call(graph_.node(factor.node), FunctionId::cos);
      });
      if (cosine == mixed.factors.end()) continue;
      const Ref angle = argument_of(graph_.node(cosine->node));
      mixed.factors.erase(cosine);
      const Ref without = product(mixed.coefficient, mixed.factors);
      for (std::size_t i = 0; i < terms.size(); ++i) {
        for (std::size_t j = i + 1; j < terms.size(); ++j) {
          if (i == k || j == k) continue;
          const std::optional<Ref> triangle = of_triangle(terms[i], terms[j], without, angle);
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
  /// `mixed` is -+2 a b.
  std::optional<Ref> of_triangle(Ref first, Ref second, Ref mixed, Ref angle) {
    if (first.negative && second.negative) {
      const std::optional<Ref> opposite = of_triangle(-first, -second, -mixed, angle);
      return opposite ? std::optional(-*opposite) : std::nullopt;
    }
    const std::optional<Ref> a = exact_root(first);
    const std::optional<Ref> b = exact_root(second);
    if (!a || !b) return std::nullopt;
    const Ref twice = doubled(times(*a, *b));
    if (mixed.node != twice.node) return std::nullopt;
    const bool is_difference = mixed.negative != twice.negative;
    const FunctionId sinusoid = is_difference ? FunctionId::sin : FunctionId::cos;
    const Ref turn = times(doubled(twice), square(call(sinusoid, half(angle))));
    return graph_.sum({square(graph_.sum({*a, -*b})), turn});
  }

  /// x where the value is x^2, of numbers and factors whose root is known.
  std::optional<Ref> exact_root(Ref value) {
    ScaledTerm term = scaled(value);
    cl_RA root = 0;
    if (term.coefficient < 0 || !cln::sqrtp(term.coefficient, &root)) return std::nullopt;
    for (Operand& factor : term.factors) {
      if (factor.weight % 2 != 0) return std::nullopt;
      factor.weight /= 2;
    }
    return product(root, term.factors);
  }
};

/// root + rest = (root^2 - rest^2)/(root - rest)
class Conjugates : GraphTerms {
 public:
  using GraphTerms::GraphTerms;

  /// Of terms of which one has a root, where root^2 - rest^2 is shorter than root^2.
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
    const Ref raised = square_of_root(root);
    const Ref numerator = sum({raised, -square(rest)});
    const bool is_shorter = term_count(numerator) < term_count(raised);
    if (!is_shorter || term_count(numerator) == 0 || has_branches(numerator)) return std::nullopt;
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
};

std::optional<Ref> kept_sum(Graph& graph, Squares squares, Ref value);

/// Differences f - g, of two factors or of what is left of two terms, where they are known.
class Differences : GraphTerms {
 public:
  Differences(Graph& graph, Squares squares) : GraphTerms(graph), squares_(squares) {}

  Rest rest_of(const std::vector<Operand>& factors) {
    Rest rest{.value = product(1, factors)};
    if (factors.empty()) rest.kind = Rest::Kind::one;
    if (factors.size() != 1) return rest;
    const auto [id, weight] = factors.front();
    const Node& node = graph_.node(id);
    rest.argument = {id, false};
    if (weight == -1) rest.kind = Rest::Kind::inverse;
    if (weight == 2) rest.kind = Rest::Kind::square;
    const bool is_root = node.kind == NodeKind::square_root;
    const bool is_unary = node.kind == NodeKind::call && function_row(node.function).arity == 1;
    if (weight != 1 || (!is_root && !is_unary)) return rest;
    rest.kind = is_root ? Rest::Kind::root : Rest::Kind::call;
    rest.function = node.function;
    rest.argument = argument_of(node);
    return rest;
  }

  /// 1 - cos(a) cos(b) = sin((a + b)/2)^2 + sin((a - b)/2)^2, where `x` is 1.
  std::optional<Ref> cosines(const ScaledTerm& x, const ScaledTerm& y) {
    if (!x.factors.empty() || y.factors.size() != 2) return std::nullopt;
    std::vector<Ref> angles;
    for (const Operand& factor : y.factors) {
      const Node& node = graph_.node(factor.node);
      if (!is_call(node, FunctionId::cos) || factor.weight != 1) return std::nullopt;
      angles.push_back(argument_of(node));
    }
    const Ref mean = half(sum({angles[0], angles[1]}));
    const Ref rest = half(sum({angles[0], -angles[1]}));
    return graph_.sum({square(call(FunctionId::sin, mean)), square(call(FunctionId::sin, rest))});
  }

  /// c (pi/2 - atan(a)) = c atan2(1, a)
  std::optional<Ref> complement(const ScaledTerm& x, const ScaledTerm& y) {
    if (x.factors.size() != 1 || graph_.node(x.factors[0].node).kind != NodeKind::pi) {
      return std::nullopt;
    }
    const Rest rest = rest_of(y.factors);
    const bool is_atan = rest.kind == Rest::Kind::call && rest.function == FunctionId::atan;
    if (x.factors[0].weight != 1 || !is_atan) return std::nullopt;
    const cl_RA ratio = y.coefficient / x.coefficient;
    if (cln::abs(ratio) != 2) return std::nullopt;
    const Ref argument = ratio < 0 ? rest.argument : -rest.argument;
    const Ref angle = graph_.call(FunctionId::atan2, {one(), argument});
    return times(graph_.rational(x.coefficient * 2), angle);
  }

  std::optional<Ref> difference(const Rest& f, const Rest& g) {
    using Kind = Rest::Kind;
    if (f.kind == Kind::call && g.kind == Kind::one) return less_one(f);
    if (f.kind == Kind::call && f.function == FunctionId::sin && g.value == f.argument) {
      const Ref third = graph_.call(FunctionId::stumpff, {f.argument, graph_.rational(3)});
      return -graph_.product({{f.argument, 3}, {third, 1}});
    }
    const Ref beside = g.kind == Kind::one ? one() : g.argument;
    if (f.kind != g.kind && g.kind != Kind::one) return std::nullopt;
    if (f.kind == Kind::inverse) return of_inverses(f.argument, beside);
    if (f.kind == Kind::square && squares_ == Squares::apart) {
      const Ref less = graph_.sum({f.argument, -beside});
      return times(less, graph_.sum({f.argument, beside}));
    }
    if (f.kind != g.kind || f.function != g.function) return std::nullopt;
    if (f.kind == Kind::root) return of_roots(f, g);
    return f.kind == Kind::call ? of_calls(f, g) : std::nullopt;
  }

 private:
  /// f - 1, which is f(a) - f(0) of cosines.
  std::optional<Ref> less_one(const Rest& f) {
    const Ref a = f.argument;
    if (f.function == FunctionId::exp) return call(FunctionId::expm1, a);
    if (f.function == FunctionId::tanh) {
      const Ref grown = graph_.sum({one(), call(FunctionId::exp, doubled(a))});
      return -quotient(graph_.rational(2), grown);
    }
    const bool is_cosine = f.function == FunctionId::cos || f.function == FunctionId::cosh;
    return is_cosine ? product_of_calls(f.function, half(a), half(a)) : std::nullopt;
  }

  /// f(mean + rest) - f(mean - rest)
  std::optional<Ref> product_of_calls(FunctionId function, Ref mean, Ref rest) {
    const auto* const rule =
        std::ranges::find(differences_of_calls, function, &DifferenceOfCalls::function);
    if (rule == differences_of_calls.end()) return std::nullopt;
    const Ref product = times(call(rule->of_mean, mean), call(rule->of_half, rest));
    return with_sign(doubled(product), rule->is_negative);
  }

  /// 1/a - 1/b = (b - a)/(a b), where b - a is kept in its turn.
  Ref of_inverses(Ref a, Ref b) {
    const Ref difference = sum({b, -a});
    const Ref top = kept_sum(graph_, squares_, difference).value_or(difference);
    return graph_.product({{top, 1}, {a, -1}, {b, -1}});
  }

  std::optional<Ref> of_roots(const Rest& f, const Rest& g) {
    if (has_branches(f.argument) || has_branches(g.argument)) return std::nullopt;
    if (!is_anchored(f.argument) && !is_anchored(g.argument)) return std::nullopt;
    const Ref top = sum({f.argument, -g.argument});
    return quotient(top, graph_.sum({f.value, g.value}));
  }

  /// b is the shorter one.
  std::optional<Ref> of_calls(const Rest& f, const Rest& g) {
    const Ref a = f.argument;
    const Ref b = g.argument;
    if (term_count(a) < term_count(b)) return std::nullopt;
    const Ref less = sum({a, -b});
    if (const auto product = product_of_calls(f.function, half(sum({a, b})), half(less))) {
      return product;
    }
    if (f.function == FunctionId::log) return call(FunctionId::log1p, quotient(less, b));
    if (f.function == FunctionId::atan) {
      return graph_.call(FunctionId::atan2, {less, sum({one(), times(a, b)})});
    }
    if (f.function != FunctionId::tan) return std::nullopt;
    return graph_.product({{call(FunctionId::sin, less), 1},
                           {call(FunctionId::cos, a), -1},
                           {call(FunctionId::cos, b), -1}});
  }

  Squares squares_;
};

/// One sum or logarithm, in the graph that it stands in.
class KeptSum : GraphTerms {
 public:
  KeptSum(Graph& graph, Squares squares) : GraphTerms(graph), squares_(squares) {}

  std::optional<Ref> kept(Ref value) {
    if (graph_.node(value.node).kind != NodeKind::sum) return std::nullopt;
    std::vector<Ref> terms = terms_of(value.node);
    bool is_changed = false;
    while (terms.size() > 1 && terms.size() <= most_terms_in_pairs && replace_some(terms)) {
      is_changed = true;
    }
    const auto better = is_changed ? graph_.sum(terms) : Conjugates(graph_)(terms);
    return better ? std::optional(with_sign(*better, value.negative)) : std::nullopt;
  }

  /// log(1 + x) = log1p(x), log(a/b) = log1p((a - b)/b), and log(a) where a - 1 is kept.
  std::optional<Ref> logarithm(Ref argument) {
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
  bool replace_some(std::vector<Ref>& terms) {
    if (Triangles(graph_).replace_one(terms)) return true;
    for (std::size_t i = 0; i < terms.size(); ++i) {
      for (std::size_t k = i + 1; k < terms.size(); ++k) {
        const std::optional<Ref> better = pair(terms[i], terms[k]);
        if (!better) continue;
        terms[i] = *better;
        terms.erase(terms.begin() + static_cast<std::ptrdiff_t>(k));
        return true;
      }
    }
    return false;
  }

  std::optional<Ref> pair(Ref first, Ref second) {
    Differences known(graph_, squares_);
    ScaledTerm x = scaled(first);
    ScaledTerm y = scaled(second);
    const std::vector<Operand> shared = take_shared(x, y);
    const auto whole = [&](const cl_RA& number, Ref rest) {
      return times(product(number, shared), rest);
    };
    if (const auto angle = known.complement(x, y)) return whole(1, *angle);
    if (const auto angle = known.complement(y, x)) return whole(1, *angle);
    Rest f = known.rest_of(x.factors);
    Rest g = known.rest_of(y.factors);
    if (x.coefficient == y.coefficient && is_odd(g)) {
      g.argument = -g.argument;  // f(a) + f(b) = f(a) - f(-b)
      g.value = -g.value;
    } else if (x.coefficient == y.coefficient && is_odd(f)) {
      f.argument = -f.argument;  // f(a) + 1 = -(f(-a) - 1)
      f.value = -f.value;
      x.coefficient = -x.coefficient;
    } else if (x.coefficient != -y.coefficient) {
      return Conjugates(graph_)({first, second});
    }
    if (const auto rewritten = known.cosines(x, y)) return whole(x.coefficient, *rewritten);
    if (const auto rewritten = known.cosines(y, x)) return whole(y.coefficient, *rewritten);
    if (const auto less = known.difference(f, g)) return whole(x.coefficient, *less);
    if (const auto less = known.difference(g, f)) return whole(-x.coefficient, *less);
    return Conjugates(graph_)({first, second});
  }

  static bool is_odd(const Rest& rest) {
    return rest.kind == Rest::Kind::call && function_row(rest.function).parity == Parity::odd;
  }

  Squares squares_;
};

std::optional<Ref> kept_sum(Graph& graph, Squares squares, Ref value) {
  return KeptSum(graph, squares).kept(value);
}

Ref kept(Graph& graph, const RebuildStep& step, Squares squares, bool& has_any) {
  const Ref same = copy(graph, step);
  const Node& node = graph.node(same.node);
  KeptSum sum(graph, squares);
  const std::optional<Ref> better = is_call(node, FunctionId::log)
                                        ? sum.logarithm(argument_of(node))
                                        : sum.kept({same.node, false});
  if (!better) return same;
  has_any = true;
  return with_sign(*better, same.negative);
}

}  // namespace

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
