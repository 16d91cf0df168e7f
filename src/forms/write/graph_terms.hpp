// graph_terms: sums and products of a Graph taken apart: terms as numbers times powers, and what is
// built from them with brackets written out.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "program/graph/graph.hpp"

namespace elgen {

/// coefficient * product of factors
struct ScaledTerm {
  cln::cl_RA coefficient = 1;
  std::vector<Operand> factors = {};  ///< by node
};

/// Whether they are one, whatever the order of the factors.
[[nodiscard]] bool is_same(const ScaledTerm& x, const ScaledTerm& y);

/// The only argument of a call, or a radicand.
[[nodiscard]] inline Ref argument_of(const Node& call) {
  return {call.operands[0].node, call.operands[0].weight < 0};
}

/// On a graph that outlives it.
class GraphTerms {
 public:
  static constexpr std::size_t most_written_out = 30;

  explicit GraphTerms(Graph& graph) : graph_(graph) {}

  Ref one() { return graph_.rational(1); }
  Ref half(Ref x) { return graph_.product({{graph_.rational(cln::cl_RA(1) / 2), 1}, {x, 1}}); }
  /// Products in it are written out.
  Ref times(Ref x, Ref y);
  /// Sums in it, and sums that are multiplied by something, are written out.
  Ref sum(const std::vector<Ref>& values);
  /// The terms that this sum is written with.
  std::vector<Ref> parts_of(const std::vector<Ref>& values);
  /// With squares of sums written out where that is no longer: (R + x)^2 - R^2 = 2 R x + x^2.
  Ref short_sum(const std::vector<Ref>& values);
  /// The terms of their sum, every sum and square of a sum in it written out; none where these are
  /// more than `most`.
  std::optional<std::vector<Ref>> written_out(const std::vector<Ref>& values,
                                              std::size_t most = most_written_out);
  Ref quotient(Ref x, Ref y) { return graph_.product({{x, 1}, {y, -1}}); }
  Ref call(FunctionId function, Ref x) { return graph_.call(function, {x}); }
  Ref doubled(Ref x) { return times(graph_.rational(2), x); }
  Ref square(Ref x) { return graph_.product({{x, 2}}); }
  /// Sums in it are written out.
  std::vector<Ref> terms_of(NodeId sum) const;
  [[nodiscard]] std::size_t term_count(Ref value) const;
  /// Whether a product has a sum, or the square of one, to write out.
  [[nodiscard]] bool has_bracket(Ref value) const;
  /// Whether it is a sum with the term 1.
  [[nodiscard]] bool has_one(Ref value) const;
  /// Products in it are written out.
  [[nodiscard]] ScaledTerm scaled(Ref value) const;
  /// Moves common factors from `x` and `y` to the result.
  static std::vector<Operand> take_shared(ScaledTerm& x, ScaledTerm& y);
  Ref product(const cln::cl_RA& coefficient, const std::vector<Operand>& factors);
  Ref product(const ScaledTerm& term) { return product(term.coefficient, term.factors); }
  /// x where the term is x^degree, of numbers and factors whose roots are known.
  std::optional<Ref> exact_root(ScaledTerm term, std::int32_t degree);
  /// Whether a term has neither coordinates nor rates: where all others vanish, the sum does not,
  /// and nothing is divided by 0.
  [[nodiscard]] bool is_anchored(Ref value) const;
  /// Whether it may vanish on one side of a branch: (|x| - x) does. Roots of numbers have none.
  [[nodiscard]] bool has_branches(Ref value) const;

 protected:
  Graph& graph_;

 private:
  std::vector<Ref> parts_of(Ref value);
  void append_written_out(Ref value, std::size_t most, std::vector<Ref>& terms);
  std::vector<Operand>::iterator first_bracket(ScaledTerm& term, std::int32_t highest_power) const;
  [[nodiscard]] ScaledTerm as_factors(Ref value) const;
  void append_power(ScaledTerm& term, NodeId base, std::int32_t exponent) const;
};

}  // namespace elgen
