// Elimination: the order in which M of a model is factorised.
#pragma once

#include <cstddef>

#include "elgen/model.hpp"

namespace elgen {

/// Frames with fewer velocities are solved by M = L D L^T in any case, which is shorter there: a
/// chain of turns takes as many operations by articulated bodies at about ten.
inline constexpr std::size_t least_of_articulated = 10;

/// Whether the last velocity goes first: where a frame carries two or more others, so that limbs do
/// not fill each other in, and where frames have least_of_articulated velocities, as articulated
/// bodies do it. It decides the relative pivots of forward dynamics.
[[nodiscard]] bool eliminates_last_first(const Model& model);

}  // namespace elgen
