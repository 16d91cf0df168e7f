// expanded_calls: the values of functions near a place, without cancellation; see remainders.hpp.
#pragma once

#include <optional>

#include "elgen/leaf_names.hpp"
#include "program/graph/graph.hpp"

namespace elgen {

/// u = u0 + D: `value`, `at`, `difference`.
struct LocalValue {
  SignedNode value = {};
  SignedNode at = {};
  SignedNode difference = {};
};

/// f(u0 + D) near u0.
struct ExpandedCall {
  SignedNode at = {};                     ///< f(u0)
  SignedNode slope = {};                  ///< f'(u0)
  SignedNode difference = {};             ///< f(u0 + D) - f(u0)
  std::optional<SignedNode> excess = {};  ///< difference - f'(u0) D; none if unknown
};

/// f(u0 + D) for f = `function` of one argument; none for other functions, and for tan and tanh
/// unless u0 = 0.
[[nodiscard]] std::optional<ExpandedCall> expanded_call(Graph& graph, FunctionId function,
                                                        const LocalValue& u);

/// sqrt(radicand) for a radicand of parameters, without a call if it is the square of a positive
/// sum: sqrt(m^2 + 2 m n + n^2) = m + n if `leaves` assumes m and n to be positive.
[[nodiscard]] SignedNode positive_root(Graph& graph, const LeafNames& leaves, SignedNode radicand);

}  // namespace elgen
