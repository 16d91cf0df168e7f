// build_closed_graph: converts a closed form to a Graph, as sums of products over denominators.
#pragma once

#include <optional>
#include <vector>

#include "forms/write/real_terms.hpp"
#include "program/graph/graph.hpp"

namespace elgen {

/// How the terms of a sum are grouped before common factors are collected.
enum class Grouping : std::uint8_t {
  none,
  by_rates,                  ///< by the product of velocities, accelerations and inputs
  by_rates_and_coordinates,  ///< also by the product of coordinates, sines and cosines
};

/// How a closed form is written. If `trigonometry` is missing, the coefficient of each product of
/// rates gets its own shortest form.
struct Layout {
  std::optional<Trigonometry> trigonometry = {};
  Grouping grouping = Grouping::none;
};

/// True for a leaf other than a parameter, a coordinate or t, such as a velocity or an input.
[[nodiscard]] bool is_rate(const Atom& atom);
/// True for parameters and pi.
[[nodiscard]] bool is_parameter(const Atom& atom);

/// Splits a sum by the roots in its terms. Each part gets its own denominator:
///
///     (a sqrt(r) + b r)/r^2   ->   a sqrt(r)/r^2,   b/r
[[nodiscard]] std::vector<Fraction> split_by_roots(const Algebra& algebra, const Fraction& form);

/// `form` as a value of `graph`; none if a sum in `form` has more than `most` terms.
[[nodiscard]] std::optional<SignedNode> build_closed_graph(Graph& graph, const Algebra& algebra,
                                                           const Fraction& form, Layout layout,
                                                           std::size_t most);

}  // namespace elgen
