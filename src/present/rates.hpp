// rates: the derivative of a closed form along a motion of its leaves.
#pragma once

#include "arithmetic.hpp"

namespace elgen::presenting {

/// How fast the leaves change; parameters stand still.
struct Motion {
  std::vector<Fraction> coordinates = {};  ///< empty: they change at their velocities
  std::vector<Fraction> velocities = {};   ///< empty: unknown
  Fraction time = {};
};

/// Displacement of one of `count` coordinates, at rest otherwise.
[[nodiscard]] Motion along_coordinate(std::size_t coordinate, std::size_t count);
/// Time alone passes.
[[nodiscard]] Motion along_time(std::size_t count);

/// None beyond the budget, and of functions with kinks where they change.
[[nodiscard]] Value rate(Arithmetic& arithmetic, const Algebra& algebra, const Fraction& x,
                         const Motion& motion);

}  // namespace elgen::presenting
