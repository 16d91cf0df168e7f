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

/// The value of `text`; a bracket stays a separate node, names are `coordinates` or pi. None if
/// `text` has another name or a syntax error, divides by 0, raises 0 to a power, or has an exponent
/// that is no integer up to 1e6.
[[nodiscard]] std::optional<SignedNode> read_value(Graph& graph, const std::string& text,
                                                   const std::vector<std::string>& coordinates,
                                                   const Limits& limits = {});

}  // namespace elgen
