// Turning: terms that exist because the velocities of a rotation are angular velocities w, not
// dq/dt.
//
// With dq/dt = N(q) v, virtual displacements are dq = N s for any vector s, and Lagrange's equation
// becomes Hamel's equation, in which [w]x is the matrix of the cross product with w:
//
//     d/dt dL/dv + [w]x dL/dw - N^T dL/dq = Q       ([w]x in the rows of rotations, 0 elsewhere)
//     C_ij = 1/2 d(C v)_i/dv_j + 1/2 (M [w]x)_ij    so that dM/dt - 2 C is skew
//
// Source: Lurie, Analytical Mechanics (2002), sections 2.10 and 7.7.
#pragma once

#include "derive/lagrangian/derivation.hpp"

namespace elgen {

/// N^T g, one entry per velocity; g is `by_coordinates`, a derivative with respect to q.
[[nodiscard]] RealVector project_to_velocities(Derivation& derivation,
                                               const RealVector& by_coordinates);

/// The seeds dq = N e_j of a unit displacement along velocity j = `velocity`.
[[nodiscard]] Seeds displacement_seeds(const Symbols& symbols, std::size_t velocity);

/// [w]x dL/dw on the velocities of rotations, 0 elsewhere: Hamel's term. `momentum` is dL/dv.
[[nodiscard]] RealVector hamel_force(Derivation& derivation, const RealVector& momentum);

/// Adds 1/2 M [w]x to the columns of rotations; `mass` and `entries` are n x n.
void add_rotation_terms(Derivation& derivation, const RealVector& mass, RealVector& entries);

/// dq/dt = N v
[[nodiscard]] RealVector coordinate_rates(const Derivation& derivation);

/// q with every quaternion divided by its length.
[[nodiscard]] RealVector normalized(Derivation& derivation);

}  // namespace elgen
