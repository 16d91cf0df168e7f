// angle_sums: expands sine and cosine of an angle that is the sum or difference of two other
// angles.
//
//     before:  cos(q1), sin(q2), cos(q1 + q2), cos(q1 + 1)
//     after:   cos(q1), sin(q2), cos(q1)*cos(q2) - sin(q1)*sin(q2), cos(q1)*cos(1) - sin(q1)*sin(1)
//
// Three operations replace a call if the sines and cosines of both angles exist already or are
// constants. The cost decides if the split pays. An angle is split only into simpler angles. 2*q1
// is not split: cos(q1)^2 - sin(q1)^2 loses digits that the call keeps.
#pragma once

#include <optional>

#include "program/graph/rebuild.hpp"

namespace elgen {

/// True for 2^k x of a leaf x: the multiple is exact, so its sine and cosine have all digits.
[[nodiscard]] bool is_exact_multiple(const Graph& graph, NodeId id);

/// Selects the angles that are split: only sums, or also differences. For nearly equal a and b, the
/// call sin(a - b) keeps all digits, but sin(a)*cos(b) - cos(a)*sin(b) cancels and loses all
/// digits.
enum class ExpandedAngles : std::uint8_t { sums, sums_and_differences };

/// The expressions with the selected angles expanded; none if no angle can be split.
[[nodiscard]] std::optional<Expressions> expand_angle_sums(
    const Expressions& expressions, ExpandedAngles which = ExpandedAngles::sums_and_differences);

}  // namespace elgen
