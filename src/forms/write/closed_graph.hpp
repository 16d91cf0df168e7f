// closed_graph: a closed form -> Graph, one sum of products over one denominator.
#pragma once

#include <optional>
#include <vector>

#include "forms/write/real_terms.hpp"
#include "program/graph/graph.hpp"

namespace elgen {

/// How the terms of a sum are put together before common factors are collected.
enum class Grouping : std::uint8_t {
  none,
  by_rates,                  ///< by one product of velocities, accelerations and inputs
  by_rates_and_coordinates,  ///< and within it one product of coordinates, sines and cosines
};

/// How a closed form is written. Without `trigonometry`, what multiplies one product of rates is
/// written in its shortest form.
struct Layout {
  std::optional<Trigonometry> trigonometry = {};
  Grouping grouping = Grouping::none;
};

/// A leaf that is no parameter, no coordinate and not t: velocities, accelerations and inputs.
[[nodiscard]] bool is_rate(const Atom& atom);
/// Parameters and numbers.
[[nodiscard]] bool is_parameter(const Atom& atom);

/// The parts of a sum by the roots in their terms, each over its own denominator:
/// (a sqrt(r) + b r)/r^2 = a sqrt(r)/r^2 + b/r.
[[nodiscard]] std::vector<Fraction> by_roots(const Algebra& algebra, const Fraction& form);

/// None where the form has more than `most` terms.
[[nodiscard]] std::optional<Ref> closed_graph(Graph& graph, const Algebra& algebra,
                                              const Fraction& form, Layout layout,
                                              std::size_t most);

}  // namespace elgen
