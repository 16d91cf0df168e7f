// Modes: the normal modes of M x'' + K x = 0 about a point of rest.
#pragma once

#include "elgen/analyse.hpp"

namespace elgen {

/// Whether the linear equations have no terms in x' and a symmetric K.
[[nodiscard]] bool is_natural(const RestPoint& point);

/// Of a natural system with a positive definite M, w^2 ascending. Of each w^2 64 digits but for the
/// square of the error of its shape in doubles; what is below 1e-20 of the largest is 0.
[[nodiscard]] std::vector<NormalMode> normal_modes(const RestPoint& point);

}  // namespace elgen
