// Twists, momenta, kinetic energies, inertial forces and weights of bodies in frames. The cost of
// each is linear in the number of transforms. All vectors are in the child frame of their
// transform: w is the angular velocity, v the velocity of the origin, and a its acceleration less
// gravity (uniform gravity is equivalent to an upward acceleration of the base):
//
//     turn          w = R^T w_p + s,   w' = R^T w_p' + (R^T w_p) x s + s'
//                   v = R^T v_p,       a = R^T a_p              s: spin of the joint
//     translation   w = w_p,           v = v_p + w x p + p'
//                   a = a_p + U p + 2 w x p' + p'',   U = [w']x + [w]x [w]x
//     body          T = 1/2 m v_c^2 + 1/2 w.I w,   v_c = v + w x c
//                   F = m (a + U c),   N = I w' + w x I w + c x F
//
// The forces are summed from the leaves to the root. The component of the moment along a joint's
// axis is the generalised force on its angle (d'Alembert-Lagrange; for rotations Euler-Poincare).
// Featherstone, Rigid Body Dynamics Algorithms (2008), chapters 2 and 5.
#pragma once

#include "derive/tree/tree.hpp"

namespace elgen {

/// Angular velocity of a transform's child frame, and velocity of its origin. tree_twists() returns
/// one twist per transform, along a direction of motion.
struct Twist {
  ExVector3 spin{0, 0, 0};
  ExVector3 velocity{0, 0, 0};
};
[[nodiscard]] std::vector<Twist> tree_twists(KinematicTree& tree, Tangent& along);

/// The twist of the child frame of transform k, from the twist `from` of its parent frame.
[[nodiscard]] Twist child_twist(KinematicTree& tree, std::size_t k, const Twist& from,
                                Tangent& along);

/// Angular velocity of transform k relative to its parent. For a rotation: the velocities of the
/// rotation, or 0 if `along` does not move the rotation. Otherwise: relative_spin().
[[nodiscard]] ExVector3 joint_spin(KinematicTree& tree, std::size_t k, Tangent& along);

/// dT/dv of the bodies, stored in the same way as generalised forces.
[[nodiscard]] TreeForces tree_momentum(KinematicTree& tree);

/// Terms of T = sum 1/2 m v_c^2 + 1/2 w.I w, along a direction of motion.
[[nodiscard]] Terms tree_kinetic_energy(KinematicTree& tree, Tangent& along);

/// The terms of T of one body whose frame has this twist.
[[nodiscard]] Terms body_kinetic_energy(VectorAlgebra& algebra, const RigidBody& body,
                                        const Twist& twist);

/// True if the mass or the first moment h is not 0.
[[nodiscard]] bool has_mass(const RigidBody& body);

/// m v_c, or m v + w x h if the inertia is about the origin.
[[nodiscard]] ExVector3 linear_momentum(VectorAlgebra& algebra, const RigidBody& body,
                                        const Twist& twist);

/// The two directions of differentiation that give an acceleration.
struct AccelerationTangents {
  Tangent& velocity_tangent;      ///< from pose to velocity
  Tangent& acceleration_tangent;  ///< from velocity to acceleration
  bool includes_gravity = false;
};

/// Motion of a transform's child frame, expressed in that frame.
struct TransformMotion {
  ExVector3 spin{0, 0, 0};
  ExVector3 spin_rate{0, 0, 0};
  ExVector3 acceleration{0, 0, 0};                                ///< of the origin, less gravity
  ExMatrix3 acceleration_gradient = {0, 0, 0, 0, 0, 0, 0, 0, 0};  ///< U, row-major
  ExVector3 spin_products{0, 0, 0};                               ///< w_y w_z, w_z w_x, w_x w_y
};
[[nodiscard]] std::vector<TransformMotion> tree_motions(KinematicTree& tree,
                                                        const AccelerationTangents& acceleration);

/// Motion of the world: at rest, with the acceleration -gravity if `includes_gravity` is set.
[[nodiscard]] TransformMotion base_motion(KinematicTree& tree, bool includes_gravity);

/// The sums of F and N over the bodies of each transform.
[[nodiscard]] std::vector<SpatialForce> inertial_forces_on_transforms(
    KinematicTree& tree, const std::vector<RigidBody>& bodies,
    const std::vector<TransformMotion>& motions);

/// Generalised inertial forces of the bodies; minus the weights if `acceleration.includes_gravity`
/// is set.
[[nodiscard]] TreeForces inertial_forces(KinematicTree& tree,
                                         const AccelerationTangents& acceleration);

/// dV/dq of the bodies' weights. For the subtree of each transform, in the transform's child frame,
/// mu is the mass, h the first moment, and g gravity:
///
///     parent   mu_p += mu,   h_p += R h + mu p
///     weight   F = -mu g,    N = g x h        (on the side of M a)
///
/// The generalised force is the component of (F, N) along the motion of the transform.
[[nodiscard]] TreeForces tree_gravity_forces(KinematicTree& tree);

/// Terms of V = -sum m gravity.p: one for each transform without parent, and one for each body
/// fixed to the world.
[[nodiscard]] Terms tree_potential_energy(KinematicTree& tree);

}  // namespace elgen
