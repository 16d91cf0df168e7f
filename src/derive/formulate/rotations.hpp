// Rotations: what the velocities of unit quaternions do to them.
#pragma once

#include <array>

#include "elgen/lagrangian.hpp"

namespace elgen {

/// N of de/dt = N w, for e = (w, x, y, z) from body to parent and w in the axes of the body:
///
///     N = 1/2 [ -x -y -z;  w -z  y;  z  w -x;  -y  x  w ]
[[nodiscard]] std::array<std::array<GiNaC::ex, 3>, 4> rate_matrix(const Symbols& symbols,
                                                                  const RotationPlace& rotation);

/// Fills `q_rates` and `rotations`; the rates of quaternions become definitions.
void add_coordinate_rates(const Model& model, Lagrangian& lagrangian);

}  // namespace elgen
