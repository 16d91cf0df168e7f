// cheapest: the form in which the values of a function cost least.
//
// Factoring sums saves products but can undo common subexpressions of two sums, and writing
// products out lets factors meet but splits common ones; sines of sums of angles can be calls or
// products of what is there. So several forms are made, counted after sharing, and put in the order
// of their costs (the first made first on a tie).
#pragma once

#include <cstddef>
#include <vector>

#include "program/graph/angle_sums.hpp"
#include "program/network/network.hpp"

namespace elgen {

/// Factored twice, with sums flattened between: factoring takes sums apart, so that their terms can
/// meet in one sum, which may factor again.
[[nodiscard]] Expressions factored(const Expressions& flat);

/// A form, and what it costs as instructions.
struct CostedNetwork {
  Network network = {};
  std::size_t cost = 0;
};

/// All forms, the cheapest first. `unfilled` says which values are the function's entries.
[[nodiscard]] std::vector<CostedNetwork> networks_by_cost(
    const Expressions& expressions, const Function& unfilled,
    Splits splits = Splits::sums_and_differences);

/// The first of them.
[[nodiscard]] Network cheapest_network(const Expressions& expressions, const Function& unfilled,
                                       Splits splits = Splits::sums_and_differences);

}  // namespace elgen
