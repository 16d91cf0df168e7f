// Twists, momenta and kinetic energies, inertial forces and weights of bodies in frames, each
// linear in the number of steps. In the axes after each step, with w the angular velocity, v the
// velocity of the origin, and a its acceleration less gravity (uniform gravity is an upward
// acceleration of the base):
//
//     turn          w = R^T w_p + s,   w' = R^T w_p' + (R^T w_p) x s + s'
//                   v = R^T v_p,       a = R^T a_p              s: spin of the turn itself
//     translation   w = w_p,           v = v_p + w x p + p'
//                   a = a_p + U p + 2 w x p' + p'',   U = [w']x + [w]x [w]x
//     body          T = 1/2 m v_c^2 + 1/2 w.I w,   v_c = v + w x c
//                   F = m (a + U c),   N = I w' + w x I w + c x F
//
// The forces are pulled back from the leaves to the root: the component of the moment along the
// axis is the generalized force on the angle (d'Alembert-Lagrange for poses, Euler-Poincare).
// Featherstone, Rigid Body Dynamics Algorithms (2008), chapters 2 and 5.
#pragma once

#include "derive/tree/tree.hpp"

namespace elgen {

/// Angular velocity and velocity of the origin of every step, along a direction of motion.
struct Twist {
  ExVector3 spin{0, 0, 0};
  ExVector3 velocity{0, 0, 0};
};
[[nodiscard]] std::vector<Twist> tree_twists(Tree& tree, Tangent& along);

/// Spin of step k itself: the velocities of a rotation where it moves, else the rate of the turn.
[[nodiscard]] ExVector3 own_spin(Tree& tree, std::size_t k, Tangent& along);

/// dT/dv of the bodies, as forces.
[[nodiscard]] TreeForces tree_momentum(Tree& tree);

/// 1/2 m v_c^2 + 1/2 w.I w of each body along a direction of motion.
[[nodiscard]] Terms tree_kinetic_energy(Tree& tree, Tangent& along);

/// Whether there is a mass, or a first moment.
[[nodiscard]] bool has_mass(const RigidBody& body);

/// m v_c, or m v + w x h.
[[nodiscard]] ExVector3 momentum_of(VectorAlgebra& algebra, const RigidBody& body,
                                    const Twist& twist);

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
  ExVector3 products{0, 0, 0};                       ///< w_y w_z, w_z w_x, w_x w_y
};
[[nodiscard]] std::vector<StepMotion> tree_motions(Tree& tree, const Acceleration& acceleration);

/// Where the base is: at rest, but for gravity.
[[nodiscard]] StepMotion base_motion(Tree& tree, bool with_gravity);

/// F and N of bodies fixed to steps.
[[nodiscard]] std::vector<SpatialForce> inertial_forces_on_steps(
    Tree& tree, const std::vector<RigidBody>& bodies, const std::vector<StepMotion>& motions);

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
