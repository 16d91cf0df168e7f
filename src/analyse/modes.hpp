// Modes: the normal modes of M x'' + K x = 0 about a point of rest.
#pragma once

#include "elgen/analyse.hpp"

namespace elgen {

/// Whether the linear equations have no terms in x' and a symmetric K.
[[nodiscard]] bool is_natural(const RestPoint& point);

/// Modes of a natural system with a positive definite M, w^2 ascending. Each w^2 is right in 64
/// digits up to the squared error of its shape in doubles; below 1e-20 of the largest it is 0.
[[nodiscard]] std::vector<NormalMode> normal_modes(const RestPoint& point);

}  // namespace elgen
