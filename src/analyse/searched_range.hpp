// Searched ranges: where the coordinates of equilibria are looked for.
#pragma once

#include "elgen/analyse.hpp"
#include "elgen/evaluate.hpp"
#include "elgen/model.hpp"

namespace elgen {

/// Solutions of 64 digits that agree to so many behind the point are one: two simple ones would be
/// nearer to each other than their own boxes are wide.
inline constexpr long root_digits = 25;

/// 2 pi
[[nodiscard]] const Real& whole_turn();

/// The angle a whole number of turns on that is the first one not below `lowest`, to root_digits.
[[nodiscard]] Real turned_above(const Real& angle, const Real& lowest);

/// The range in which a coordinate is looked for; null where it has none, or that is a whole turn.
[[nodiscard]] const Interval* searched_range(const Coordinate& coordinate, SearchKind kind);

/// Whether one of the values from `highest` - width to `highest`, or a whole number of turns on
/// where the coordinate turns, is in the range.
[[nodiscard]] bool is_in_range(const Coordinate& coordinate, SearchKind kind, const Real& highest,
                               const Real& width = {});

}  // namespace elgen
