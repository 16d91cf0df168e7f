// triangles: see kept_terms.hpp.
#include <algorithm>
#include <optional>

#include "forms/write/kept_terms.hpp"

namespace elgen {
namespace {

using cln::cl_RA;

class Triangles : GraphTerms {
 public:
  Triangles(Graph& graph, Keeping keeping) : GraphTerms(graph), keeping_(keeping) {}

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
          if (i == k || j == k || !may_be_triangle(parts[i], parts[j], mixed)) continue;
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
  /// The coefficients of C a^2, C b^2 and 2 C a b.
  static bool may_be_triangle(const ScaledTerm& first, const ScaledTerm& second,
                              const ScaledTerm& mixed) {
    return first.coefficient * second.coefficient * 4 == mixed.coefficient * mixed.coefficient;
  }

  /// `mixed` is -+2 C a b: with + it is the cosine of c/2.
  std::optional<Ref> of_triangle(ScaledTerm first, ScaledTerm second, const ScaledTerm& mixed,
                                 Ref angle) {
    const cl_RA common = first.coefficient;
    const cl_RA ratio = second.coefficient / common;
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
    if (keeping_.squares == Squares::apart) {
      const Ref more = square(graph_.sum({*a, *b}));
      const Ref near = is_difference ? less : more;
      const Ref far = is_difference ? more : less;
      return times(scale, graph_.sum({times(near, cosine), times(far, sine)}));
    }
    const Ref turn = times(times(graph_.rational(4), both), is_difference ? sine : cosine);
    return times(scale, graph_.sum({less, turn}));
  }

  Keeping keeping_;
};

}  // namespace

bool replace_triangle(Graph& graph, Keeping keeping, std::vector<Ref>& terms) {
  return Triangles(graph, keeping).replace_one(terms);
}

}  // namespace elgen
