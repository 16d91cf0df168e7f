// Steps: Lagrange's equations as a student derives them, each step over the definitions.
//
//     delta S = 0, positions, velocities by the chain rule, T, V, L = T - V, then for every q
//     dL/dv, d/dt dL/dv, dL/dq,      d/dt dL/dv - dL/dq + dD/dv = Q + B u
//
// and E = sum v dL/dv - L with dL/dt at fixed q and v: where it is zero, and no force or
// dissipation works, E is conserved; where dL/dq is zero, and no force acts on q, its momentum
// dL/dv is.
#pragma once

#include "elgen/equations_of_motion.hpp"

namespace elgen {

/// The functions of the equations in order: "positions" and "velocities" (one field of 3 rows per
/// mass), "energies" (fields T, V, or L where it is given whole), one per velocity named like it
/// (fields momentum, momentum_rate, partial, dissipation, force: dL/dv, d/dt dL/dv, dL/dq, dD/dv,
/// Q + B u), "invariants" (fields E, L_by_t).
///
/// Every field but those of the masses has a row for each summand, as it was typed: those of T and
/// then those of -V, or those of L; of dD/dv those of D. Points and bodies together are one of
/// each.
struct Steps {
  EquationsOfMotion equations = {};
  std::vector<OutputRequest> requests = {};  ///< of the functions, for lower()
  std::vector<Entity> masses = {};           ///< the point or body of each field of the positions
};

[[nodiscard]] Result<Steps> derive_steps(const Lagrangian& lagrangian);

}  // namespace elgen
