// cheapest: the form in which the values of a function cost least.
//
// Pulling common factors out of sums saves products but can undo what two sums would share, and
// writing products out lets factors meet but takes shared ones apart; sines of sums of angles can
// be calls or products of what is there. So several forms are made, counted after sharing, and the
// cheapest is kept (the first on a tie).
#pragma once

#include "lower/graph/angle_sums.hpp"
#include "lower/network/network.hpp"

namespace elgen {

/// Factored twice, with sums flattened between: factoring takes sums apart, so that their terms can
/// meet in one sum, which may factor again.
[[nodiscard]] Expressions factored(const Expressions& flat);

/// `unfilled` says which values are the function's entries.
[[nodiscard]] Network cheapest_network(const Expressions& expressions, const Function& unfilled,
                                       Splits splits = Splits::sums_and_differences);

}  // namespace elgen
