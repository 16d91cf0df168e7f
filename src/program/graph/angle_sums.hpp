// angle_sums: sine and cosine of an angle that is the sum or difference of two others that occur.
//
//     before:  cos(q1), sin(q2), cos(q1 + q2), cos(q1 + 1)
//     after:   cos(q1), sin(q2), cos(q1)*cos(q2) - sin(q1)*sin(q2), cos(q1)*cos(1) - sin(q1)*sin(1)
//
// Three operations for a call, where the sines and cosines of the parts are there anyway, or are
// numbers; the cost decides whether that pays. An angle is only ever taken apart into simpler ones,
// and 2*q1 is not: cos(q1)^2 - sin(q1)^2 loses digits that the call has.
#pragma once

#include <optional>

#include "program/graph/rebuild.hpp"

namespace elgen {

/// 2^k x of a leaf x: its sine and cosine are known to all digits.
[[nodiscard]] bool is_exact_multiple(const Graph& graph, NodeId id);

/// Which angles are taken apart. The sine of a difference of nearly equal angles has all its
/// digits, the products have none.
enum class Splits : std::uint8_t { sums, sums_and_differences };

/// Nothing where no angle is such a sum.
[[nodiscard]] std::optional<Expressions> expand_angle_sums(
    const Expressions& expressions, Splits which = Splits::sums_and_differences);

}  // namespace elgen
