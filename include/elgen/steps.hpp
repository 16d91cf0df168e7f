// Steps: Lagrange's equations as a student derives them, each step over the definitions.
//
//     delta S = 0, positions, velocities by the chain rule, T, V, L = T - V, then for every q
//     dL/dv, d/dt dL/dv, dL/dq,      d/dt dL/dv - dL/dq + dD/dv = Q + B u + A^T lambda
//
// Also E = sum v dL/dv - L with dL/dt at fixed q and v. If dL/dt is 0 and no force, dissipation or
// constraint does work, E is conserved. If dL/dq is 0 and no force or multiplier acts on q, its
// momentum dL/dv is conserved.
#pragma once

#include "elgen/equations_of_motion.hpp"

namespace elgen {

/// The functions of the equations, in order. The first three exist only if the model has masses or
/// constraints.
///
///     positions, velocities   one field of 3 rows per mass
///     constraints             one field per constraint: f, or phi; then a 0
///     energies                T, V; or L if it is declared
///     one per velocity, with  momentum dL/dv, momentum_rate d/dt dL/dv, partial dL/dq,
///     its name                dissipation dD/dv, force Q + B u + A^T lambda
///     invariants              E, L_by_t
///
/// Every field, except for masses and constraints, has one row per summand as typed: the summands
/// of T, then of -V, or the summands of L; for dissipation the summands of D. Points and bodies
/// together are one summand of T and one of V.
struct Steps {
  EquationsOfMotion equations = {};
  std::vector<OutputRequest> requests = {};  ///< of the functions, for lower()
  std::vector<Entity> masses = {};           ///< the point or body of each field of `positions`
};

[[nodiscard]] Result<Steps> derive_steps(const Lagrangian& lagrangian);

}  // namespace elgen
