// cheapest: finds the form of lowest cost for the values of a function.
//
// Factoring sums saves products but can destroy common subexpressions of two sums. Expanding
// products lets factors meet but splits shared products. The sine of a sum of angles can be a call,
// or products of values that exist already. So several forms are built, their operations are
// counted after common-subexpression elimination, and the forms are sorted by cost (forms of equal
// cost in the order in which they were built).
#pragma once

#include <cstddef>
#include <vector>

#include "program/graph/angle_sums.hpp"
#include "program/network/network.hpp"

namespace elgen {

/// `flat`, factored, flattened and factored again: the first factoring splits sums, and flattening
/// can then join terms of different sums in one sum.
[[nodiscard]] Expressions factor_twice(const Expressions& flat);

/// A form, and the cost() of its instructions.
struct CostedNetwork {
  Network network = {};
  std::size_t cost = 0;
};

/// All forms, the cheapest first. The entries of `unfilled` are indices of values, see
/// without_instructions().
[[nodiscard]] std::vector<CostedNetwork> networks_by_cost(
    const Expressions& expressions, const Function& unfilled,
    ExpandedAngles splits = ExpandedAngles::sums_and_differences);

/// The cheapest form.
[[nodiscard]] Network cheapest_network(
    const Expressions& expressions, const Function& unfilled,
    ExpandedAngles splits = ExpandedAngles::sums_and_differences);

}  // namespace elgen
