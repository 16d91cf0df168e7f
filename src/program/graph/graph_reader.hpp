// Expressions of the model language as text -> values of a Graph.
//
//     exp(1)+cos(1)-1   ->   the sum of three terms
//     (a*b)^2*c         ->   a product of two factors, one of them the square of a product
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "elgen/limits.hpp"
#include "program/graph/graph.hpp"

namespace elgen {

/// Keeps the sums and products of the text: a bracket is a separate node. Names are coordinates.
/// None if the text contains anything but numbers, pi, functions and coordinates.
[[nodiscard]] std::optional<Ref> read_value(Graph& graph, const std::string& text,
                                            const std::vector<std::string>& coordinates,
                                            const Limits& limits = {});

}  // namespace elgen
