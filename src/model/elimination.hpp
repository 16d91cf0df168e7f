// Elimination: the order in which M of a model is factorised, M = L D L^T.
#pragma once

#include <cstddef>

#include "elgen/model.hpp"

namespace elgen {

/// With fewer velocities, M = L D L^T needs fewer operations than articulated bodies. For a chain
/// of turns, both need the same number at about ten velocities.
inline constexpr std::size_t min_articulated_velocities = 10;

/// True if the last velocity is eliminated first. This is the case if a frame carries at least two
/// others, so that limbs cause no fill-in between them. It is also the case if a model with frames
/// has at least min_articulated_velocities velocities, as articulated bodies require. The order
/// determines the relative pivots of forward dynamics.
[[nodiscard]] bool eliminates_last_first(const Model& model);

}  // namespace elgen
