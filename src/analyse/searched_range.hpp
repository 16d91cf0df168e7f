// Searched ranges: the ranges in which the coordinates of equilibria are searched.
#pragma once

#include "elgen/analyse.hpp"
#include "elgen/evaluate.hpp"
#include "elgen/model.hpp"

namespace elgen {

/// Solutions in 64 digits that agree to this many decimal places are the same. Two different simple
/// solutions cannot be that close, because their boxes are wider.
inline constexpr long root_digits = 25;

/// 2 pi.
[[nodiscard]] const Real& whole_turn();

/// The smallest `angle` + 2 pi k, k an integer, that is at least `lowest` - 2 pi 1e-25.
[[nodiscard]] Real wrap_above(const Real& angle, const Real& lowest);

/// The searched range of a coordinate; null if it has no range, or if the range is a whole turn.
[[nodiscard]] const Interval* searched_range(const Coordinate& coordinate, SearchKind kind);

/// True if the range intersects [highest - width, highest] or, for an angle, this interval shifted
/// by whole turns. True also if the coordinate has no searched range.
[[nodiscard]] bool is_in_range(const Coordinate& coordinate, SearchKind kind, const Real& highest,
                               const Real& width = {});

}  // namespace elgen
