// Expressions as text -> values of a Graph, and the constants of a dumped Program.
//
//     exp(1)+cos(1)-1   ->   the sum of three terms
//     (a*b)^2*c         ->   a product of two factors, one of them the square of a product
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "elgen/constant.hpp"
#include "program/graph/graph.hpp"

namespace elgen::test {

/// The sums and products of the text as it has them: a bracket is a node of its own. Names are
/// those of coordinates. None where it is no expression of numbers, pi, functions and these.
[[nodiscard]] std::optional<Ref> read_value(Graph& graph, const std::string& text,
                                            const std::vector<std::string>& coordinates);

/// None where it is no expression of numbers, pi and functions, or has no value. The graph gives it
/// the form that it had when it was printed.
[[nodiscard]] std::optional<Constant> read_constant(const std::string& text);

}  // namespace elgen::test
