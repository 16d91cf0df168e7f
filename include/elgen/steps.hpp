// Steps: Lagrange's equations as a student derives them. Each step is an output over the
// definitions of the derivation.
//
//     delta S = 0, positions, velocities by the chain rule, T, V, L = T - V, then for every q
//     dL/dv, d/dt dL/dv, dL/dq,      d/dt dL/dv - dL/dq + dD/dv = Q + B u + A^T lambda
//
// A further step is E = sum v dL/dv - L with dL/dt at fixed q and v. If dL/dt is 0 and no force,
// dissipation or constraint does work, E is conserved. If dL/dq is 0 and no force or multiplier
// acts on q, the momentum dL/dv of q is conserved.
#pragma once

#include "elgen/equations_of_motion.hpp"
#include "elgen/frame_quantities.hpp"

namespace elgen {

/// The functions of the steps, in this order. The first three exist only if the model has masses or
/// constraints.
///
///     positions, velocities   one field of 3 rows per mass
///     constraints             one field per constraint: f, or phi; then a field for the right side
///     0 energies                T, V; or L if it is declared (name of a velocity)    one function
///     per velocity: momentum dL/dv, momentum_rate d/dt dL/dv,
///                             partial dL/dq, dissipation dD/dv, force Q + B u + A^T lambda
///     invariants              E, L_by_t
///
/// `force` has one row. T, V, L and dissipation have one row per typed summand of T, V, L and D.
/// momentum, momentum_rate, partial, E and L_by_t have one row per summand of L. If L is not
/// declared, the summands of T come first, then the summands of -V. All points and bodies together
/// contribute one summand of T and one of V.
struct DerivationSteps {
  EquationsOfMotion equations = {};
  std::vector<OutputRequest> requests = {};  ///< the request of each function, in order
  std::vector<Entity> masses = {};           ///< the point or body of each field of `positions`
};

[[nodiscard]] Result<DerivationSteps> derive_textbook_steps(const Lagrangian& lagrangian);

/// The quantities of frames and their bodies: one function with one field each, frames first. In a
/// planar model an angular velocity has one row, and other vectors have two. A zero vector has one
/// row. A long quantity is written over components of earlier quantities, which are open values
/// with names such as omega_arm[1].
struct FrameSteps {
  EquationsOfMotion equations = {};
  std::vector<OutputRequest> requests = {};
  std::vector<FrameQuantity> quantities = {};  ///< of each function
};

/// Empty if no frame carries a body.
[[nodiscard]] FrameSteps derive_frame_steps(const Lagrangian& lagrangian, const Model& model);

}  // namespace elgen
