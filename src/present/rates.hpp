// rates: the derivative of a closed form along a motion of its leaves.
#pragma once

#include "present/arithmetic.hpp"

namespace elgen {

/// How fast the leaves change; parameters stand still.
struct LeafRates {
  std::vector<Fraction> coordinates = {};  ///< empty: they change at their velocities
  std::vector<Fraction> velocities = {};   ///< empty: unknown
  Fraction time = {};
};

/// Displacement of one of `count` coordinates, at rest otherwise.
[[nodiscard]] LeafRates along_coordinate(std::size_t coordinate, std::size_t count);
/// Time alone passes.
[[nodiscard]] LeafRates along_time(std::size_t count);

/// None beyond the budget, and of functions with kinks where they change.
[[nodiscard]] Value rate(Arithmetic& arithmetic, const Algebra& algebra, const Fraction& x,
                         const LeafRates& motion);

}  // namespace elgen
