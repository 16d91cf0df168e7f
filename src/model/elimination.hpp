// Elimination: the order in which M of a model is factorised.
#pragma once

#include <cstddef>

#include "elgen/model.hpp"

namespace elgen {

/// With fewer velocities, frames are solved by M = L D L^T, which is shorter there: for a chain of
/// turns, articulated bodies take as many operations at about ten.
inline constexpr std::size_t least_of_articulated = 10;

/// Whether the last velocity is eliminated first: if a frame carries two or more others, so that
/// limbs cause no fill-in between them, and if frames have least_of_articulated velocities, as
/// articulated bodies need it. This order decides the relative pivots of forward dynamics.
[[nodiscard]] bool eliminates_last_first(const Model& model);

}  // namespace elgen
