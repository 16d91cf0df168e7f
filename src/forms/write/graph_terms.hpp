// graph_terms: splits sums and products of a Graph into terms (a number times powers), and builds
// expressions with expanded brackets.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "program/graph/graph.hpp"

namespace elgen {

/// coefficient * product of factors, which are nodes of a Graph; a RealTerm has atoms of an Algebra
/// instead.
struct ScaledTerm {
  cln::cl_RA coefficient = 1;
  std::vector<Operand> factors = {};  ///< weight: the exponent
};

/// True if both are equal; the order of factors does not matter.
[[nodiscard]] bool is_same(const ScaledTerm& x, const ScaledTerm& y);

/// The only argument of a call, or the radicand of a root.
[[nodiscard]] inline Ref argument_of(const Node& call) {
  return {call.operands[0].node, call.operands[0].weight < 0};
}

/// Splits and builds sums and products of `graph`; keeps a reference to `graph`.
class GraphTerms {
 public:
  static constexpr std::size_t most_written_out = 30;

  explicit GraphTerms(Graph& graph) : graph_(graph) {}

  Ref one() { return graph_.rational(1); }
  Ref half(Ref x) { return graph_.product({{graph_.rational(cln::cl_RA(1) / 2), 1}, {x, 1}}); }
  /// x y, with nested products flattened.
  Ref times(Ref x, Ref y);
  /// The sum of `values`, with nested sums flattened and products with a sum expanded.
  Ref sum(const std::vector<Ref>& values);
  /// The terms of sum().
  std::vector<Ref> parts_of(const std::vector<Ref>& values);
  /// sum(), but with squares of sums expanded if the expanded sum is not longer:
  ///
  ///     (R + x)^2 - R^2   ->   2 R x + x^2
  Ref short_sum(const std::vector<Ref>& values);
  /// The terms of the sum, with all sums and squares of sums in it expanded. None if there are more
  /// than `most`.
  std::optional<std::vector<Ref>> expanded_terms(const std::vector<Ref>& values,
                                                 std::size_t most = most_written_out);
  Ref quotient(Ref x, Ref y) { return graph_.product({{x, 1}, {y, -1}}); }
  Ref call(FunctionId function, Ref x) { return graph_.call(function, {x}); }
  Ref doubled(Ref x) { return times(graph_.rational(2), x); }
  Ref square(Ref x) { return graph_.product({{x, 2}}); }
  /// The terms of a sum, with nested sums flattened.
  std::vector<Ref> terms_of(NodeId sum) const;
  [[nodiscard]] std::size_t term_count(Ref value) const;
  /// True for a product with a sum, or the square of a sum, as a factor.
  [[nodiscard]] bool has_bracket(Ref value) const;
  /// True for a sum with the term 1.
  [[nodiscard]] bool has_term_one(Ref value) const;
  /// The value as coefficient and factors, with nested products flattened.
  [[nodiscard]] ScaledTerm scaled(Ref value) const;
  /// Removes the common factors from x and y, and returns them.
  static std::vector<Operand> take_shared(ScaledTerm& x, ScaledTerm& y);
  Ref product(const cln::cl_RA& coefficient, const std::vector<Operand>& factors);
  Ref product(const ScaledTerm& term) { return product(term.coefficient, term.factors); }
  /// x with x^degree = term, if the coefficient and all factors have such roots; otherwise none.
  std::optional<Ref> exact_root(ScaledTerm term, std::int32_t degree);
  /// True if a term contains only parameters. The sum then does not vanish when all its other terms
  /// vanish, so it may be a divisor.
  [[nodiscard]] bool has_parameter_term(Ref value) const;
  /// True if the value contains a function with branches, or a root of a value that is not
  /// constant. The value may then vanish on one side of a branch, as |x| - x does.
  [[nodiscard]] bool has_branches(Ref value) const;

 protected:
  Graph& graph_;

 private:
  std::vector<Ref> parts_of(Ref value);
  void append_expanded(Ref value, std::size_t most, std::vector<Ref>& terms);
  std::vector<Operand>::iterator first_bracket(ScaledTerm& term, std::int32_t highest_power) const;
  [[nodiscard]] ScaledTerm as_factors(Ref value) const;
  void append_power(ScaledTerm& term, NodeId base, std::int32_t exponent) const;
};

}  // namespace elgen
