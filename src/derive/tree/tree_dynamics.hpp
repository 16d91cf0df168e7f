// Inertial forces and weights of bodies in frames, each linear in the number of steps. In the axes
// after each step, with w the angular velocity and a the acceleration of the origin less gravity
// (uniform gravity is an upward acceleration of the base):
//
//     turn          w = R^T w_p + s,   w' = R^T w_p' + (R^T w_p) x s + s',   a = R^T a_p
//     translation   a = a_p + U p + 2 w x p' + p'',   U = [w']x + [w]x [w]x
//     body          F = m (a + U c),   N = I w' + w x I w + c x F
//
// s is the spin of the turn itself. The forces are pulled back from the leaves to the root: the
// component of the moment along the axis is the generalized force on the angle (d'Alembert-Lagrange
// for poses, Euler-Poincare). Featherstone, Rigid Body Dynamics Algorithms (2008), chapter 5.
#pragma once

#include "derive/tree/tree.hpp"

namespace elgen {

/// Which derivatives of the motion an inertial force is made of.
struct Acceleration {
  Tangent& first;   ///< from pose to velocity
  Tangent& second;  ///< from velocity to acceleration
  bool with_gravity = false;
};

/// Motion of what is fixed to a step, in the axes after it.
struct StepMotion {
  ExVector3 spin{0, 0, 0};
  ExVector3 spin_rate{0, 0, 0};
  ExVector3 acceleration{0, 0, 0};                   ///< of the origin, less gravity
  ExMatrix3 gradient = {0, 0, 0, 0, 0, 0, 0, 0, 0};  ///< U, row-major
};
[[nodiscard]] std::vector<StepMotion> tree_motions(Tree& tree, const Acceleration& acceleration);

/// Where the base is: at rest, but for gravity.
[[nodiscard]] StepMotion base_motion(Tree& tree, bool with_gravity);

/// F and N of the bodies fixed to every step.
[[nodiscard]] std::vector<SpatialForce> inertial_forces_on_steps(
    Tree& tree, const std::vector<StepMotion>& motions);

/// Inertial forces (and weights) of the bodies.
[[nodiscard]] TreeForces inertial_forces(Tree& tree, const Acceleration& acceleration);

/// dV/dq of the bodies' weights: with mu the mass and h the first moment of all that a step
/// carries, in the axes after it, and g the gravity there,
///
///     parent   mu_p += mu,   h_p += R h + mu p
///     weight   F = -mu g,    N = g x h        (on the side of M a)
///
/// pulled back as the component along each step.
[[nodiscard]] TreeForces tree_gravity(Tree& tree);

/// -m gravity.p of each body.
[[nodiscard]] Terms tree_potential_energy(Tree& tree);

}  // namespace elgen
