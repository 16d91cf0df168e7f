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
[[nodiscard]] bool are_equal_terms(const ScaledTerm& x, const ScaledTerm& y);

/// The only argument of a call, or the radicand of a root.
[[nodiscard]] inline SignedNode argument_of(const Node& call) {
  return {call.operands[0].node, call.operands[0].weight < 0};
}

/// Splits and builds sums and products of `graph`; keeps a reference to `graph`.
class GraphTermBuilder {
 public:
  static constexpr std::size_t most_expanded_terms = 30;

  explicit GraphTermBuilder(Graph& graph) : graph_(graph) {}

  SignedNode one() { return graph_.rational(1); }
  SignedNode half(SignedNode x) {
    return graph_.product({{graph_.rational(cln::cl_RA(1) / 2), 1}, {x, 1}});
  }
  /// x y, with nested products flattened.
  SignedNode multiply(SignedNode x, SignedNode y);
  /// The sum of `values`, with nested sums flattened and products with a sum expanded.
  SignedNode sum(const std::vector<SignedNode>& values);
  /// The terms of sum().
  std::vector<SignedNode> distribute_products(const std::vector<SignedNode>& values);
  /// sum(), but with squares of sums expanded if the expanded sum is not longer:
  ///
  ///     (R + x)^2 - R^2   ->   2 R x + x^2
  SignedNode short_sum(const std::vector<SignedNode>& values);
  /// The terms of the sum of `values`, with products and squares of sums expanded. None if there
  /// are more than `most` terms.
  std::optional<std::vector<SignedNode>> expanded_terms(const std::vector<SignedNode>& values,
                                                        std::size_t most = most_expanded_terms);
  /// The sum of expanded_terms(); a plain sum if these are too many.
  SignedNode expanded_sum(const std::vector<SignedNode>& values) {
    return graph_.sum(expanded_terms(values).value_or(values));
  }
  SignedNode quotient(SignedNode x, SignedNode y) { return graph_.product({{x, 1}, {y, -1}}); }
  /// x/y with nested products flattened, so that common factors cancel.
  SignedNode divide(SignedNode x, SignedNode y);
  SignedNode call(FunctionId function, SignedNode x) { return graph_.call(function, {x}); }
  SignedNode multiply_by_two(SignedNode x) { return multiply(graph_.rational(2), x); }
  SignedNode square(SignedNode x) { return graph_.product({{x, 2}}); }
  /// The terms of a sum, with nested sums flattened.
  std::vector<SignedNode> terms_of(NodeId sum) const;
  [[nodiscard]] std::size_t term_count(SignedNode value) const;
  /// True for a product with a sum, or the square of a sum, as a factor.
  [[nodiscard]] bool has_bracket(SignedNode value) const;
  /// True for a sum with the term 1.
  [[nodiscard]] bool has_term_one(SignedNode value) const;
  /// The value as coefficient and factors, with nested products flattened.
  [[nodiscard]] ScaledTerm split_term(SignedNode value) const;
  /// Removes the common factors from x and y; returns these factors.
  static std::vector<Operand> extract_common_factors(ScaledTerm& x, ScaledTerm& y);
  SignedNode product(const cln::cl_RA& coefficient, const std::vector<Operand>& factors);
  SignedNode product(const ScaledTerm& term) { return product(term.coefficient, term.factors); }
  /// x with x^degree = term, if the coefficient and all factors have such roots; otherwise none.
  std::optional<SignedNode> exact_root(ScaledTerm term, std::int32_t degree);
  /// True if a term of `value` contains only parameters. If all other terms vanish, `value` is then
  /// not 0, so `value` may be a divisor.
  [[nodiscard]] bool has_parameter_term(SignedNode value) const;
  /// True if `value` contains no leaf other than parameters.
  [[nodiscard]] bool has_only_parameters(SignedNode value) const;
  /// True if the value contains a function with branches, or a root of a value that is not
  /// constant. The value may then vanish on one side of a branch, as |x| - x does.
  [[nodiscard]] bool has_branches(SignedNode value) const;

 protected:
  Graph& graph_;

 private:
  std::vector<SignedNode> parts_of(SignedNode value);
  void append_expanded_terms(SignedNode value, std::size_t most, std::vector<SignedNode>& terms);
  std::vector<Operand>::iterator find_bracket(ScaledTerm& term, std::int32_t highest_power) const;
  [[nodiscard]] ScaledTerm split_into_factors(SignedNode value) const;
  void append_power(ScaledTerm& term, NodeId base, std::int32_t exponent) const;
};

}  // namespace elgen
