// Searched ranges: where coordinates of equilibria are searched.
#pragma once

#include "elgen/analyse.hpp"
#include "elgen/evaluate.hpp"
#include "elgen/model.hpp"

namespace elgen {

/// Solutions in 64 digits that agree to so many decimal places are one. Two simple ones would be
/// closer than the widths of their boxes.
inline constexpr long root_digits = 25;

/// 2 pi.
[[nodiscard]] const Real& whole_turn();

/// The first angle not below `lowest`, to root_digits, that differs from `angle` by whole turns.
[[nodiscard]] Real turned_above(const Real& angle, const Real& lowest);

/// The searched range of a coordinate; null if it has none or a whole turn.
[[nodiscard]] const Interval* searched_range(const Coordinate& coordinate, SearchKind kind);

/// Whether the range contains a value between `highest` - width and `highest`, up to whole turns of
/// angles.
[[nodiscard]] bool is_in_range(const Coordinate& coordinate, SearchKind kind, const Real& highest,
                               const Real& width = {});

}  // namespace elgen
