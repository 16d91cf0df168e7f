// Elimination: the order in which M of a model is factorised, M = L D L^T.
#pragma once

#include <cstddef>

#include "elgen/model.hpp"

namespace elgen {

/// The least number of velocities for the articulated-body algorithm. With fewer velocities, M = L
/// D L^T needs fewer operations; for a chain of hinges, both need equally many at about ten
/// velocities.
inline constexpr std::size_t min_articulated_velocities = 10;

/// True if velocities are eliminated from the last to the first, false if from the first to the
/// last. The order determines the relative pivots of forward dynamics. True for models with frames
/// and at least min_articulated_velocities velocities, because the articulated-body algorithm has
/// this order. Also true if a frame carries at least two other frames, because there is then no
/// fill-in between branches of the tree.
[[nodiscard]] bool eliminates_backward(const Model& model);

}  // namespace elgen
