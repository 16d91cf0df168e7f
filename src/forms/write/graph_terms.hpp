// graph_terms: sums and products of a Graph taken apart: terms as numbers times powers, and what is
// built from them with brackets written out.
#pragma once

#include <cstddef>
#include <vector>

#include "program/graph/graph.hpp"

namespace elgen {

/// coefficient * product of factors
struct ScaledTerm {
  cln::cl_RA coefficient = 1;
  std::vector<Operand> factors = {};  ///< by node
};

/// The only argument of a call, or a radicand.
[[nodiscard]] inline Ref argument_of(const Node& call) {
  return {call.operands[0].node, call.operands[0].weight < 0};
}

/// On a graph that outlives it.
class GraphTerms {
 public:
  explicit GraphTerms(Graph& graph) : graph_(graph) {}

  Ref one() { return graph_.rational(1); }
  Ref half(Ref x) { return graph_.product({{graph_.rational(cln::cl_RA(1) / 2), 1}, {x, 1}}); }
  /// Products in it are written out.
  Ref times(Ref x, Ref y);
  /// Sums in it, and sums that are multiplied by something, are written out.
  Ref sum(const std::vector<Ref>& values);
  Ref quotient(Ref x, Ref y) { return graph_.product({{x, 1}, {y, -1}}); }
  Ref call(FunctionId function, Ref x) { return graph_.call(function, {x}); }
  Ref doubled(Ref x) { return times(graph_.rational(2), x); }
  Ref square(Ref x) { return graph_.product({{x, 2}}); }
  /// Sums in it are written out.
  std::vector<Ref> terms_of(NodeId sum) const;
  [[nodiscard]] std::size_t term_count(Ref value) const;
  /// Whether it is a sum with the term 1.
  [[nodiscard]] bool has_one(Ref value) const;
  /// Products in it are written out.
  [[nodiscard]] ScaledTerm scaled(Ref value) const;
  /// Moves common factors from `x` and `y` to the result.
  static std::vector<Operand> take_shared(ScaledTerm& x, ScaledTerm& y);
  Ref product(const cln::cl_RA& coefficient, const std::vector<Operand>& factors);
  /// Whether a term has neither coordinates nor rates: where all others vanish, the sum does not,
  /// and nothing is divided by 0.
  [[nodiscard]] bool is_anchored(Ref value) const;
  /// Whether it may vanish on one side of a branch: (|x| - x) does.
  [[nodiscard]] bool has_branches(Ref value) const;

 protected:
  Graph& graph_;

 private:
  std::vector<Ref> parts_of(Ref value);
  void append_power(ScaledTerm& term, NodeId base, std::int32_t exponent) const;
};

}  // namespace elgen
