// Steps: Lagrange's equations as a student derives them, each step over the definitions.
//
//     delta S = 0, positions, velocities by the chain rule, T, V, L = T - V, then for every q
//     dL/dv, d/dt dL/dv, dL/dq,      d/dt dL/dv - dL/dq + dD/dv = Q + B u + A^T lambda
//
// and E = sum v dL/dv - L with dL/dt at fixed q and v: where it is zero, and no force, dissipation
// or constraint works, E is conserved; where dL/dq is zero, and no force or multiplier acts on q,
// its momentum dL/dv is.
#pragma once

#include "elgen/equations_of_motion.hpp"

namespace elgen {

/// The functions of the equations in order: "positions" and "velocities" (one field of 3 rows per
/// mass), "constraints" (a field for each: f, or phi of a velocity; then a 0), "energies" (fields
/// T, V, or L where it is given whole), one per velocity named like it (fields momentum,
/// momentum_rate, partial, dissipation, force: dL/dv, d/dt dL/dv, dL/dq, dD/dv, Q + B u + A^T
/// lambda), "invariants" (fields E, L_by_t). The first three are there where the model has such.
///
/// Every field but those of masses and constraints has a row for each summand, as it was typed:
/// those of T and then those of -V, or those of L; of dD/dv those of D. Points and bodies together
/// are one of each.
struct Steps {
  EquationsOfMotion equations = {};
  std::vector<OutputRequest> requests = {};  ///< of the functions, for lower()
  std::vector<Entity> masses = {};           ///< the point or body of each field of the positions
};

[[nodiscard]] Result<Steps> derive_steps(const Lagrangian& lagrangian);

}  // namespace elgen
