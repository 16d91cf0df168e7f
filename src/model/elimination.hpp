// Elimination: the order in which M of a model is factorised, M = L D L^T.
#pragma once

#include <cstddef>

#include "elgen/model.hpp"

namespace elgen {

/// The least number of velocities for the articulated-body algorithm. With fewer velocities, M = L
/// D L^T needs fewer operations; for a chain of hinges, the numbers are equal at about ten
/// velocities.
inline constexpr std::size_t min_articulated_velocities = 10;

/// The order in which velocities are eliminated: true from the last to the first, false from the
/// first to the last. The order determines the relative pivots of forward dynamics. True if a frame
/// carries at least two other frames: then there is no fill-in between branches of the tree. True
/// if a model with frames has at least min_articulated_velocities velocities: the articulated-body
/// algorithm has this order.
[[nodiscard]] bool eliminates_backward(const Model& model);

}  // namespace elgen
