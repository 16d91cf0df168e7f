// Articulated-body algorithm: solves M a = Q for bodies in frames without forming M. The cost is
// linear in the number of transforms. Every velocity must move one transform, by a unit twist S in
// the child frame of the transform:
//
//     a = a0 + d      a0: accelerations at a = 0, less gravity;   p: forces at a0
//     inward          U = I S,   D = S.U + J,   L = U/D,   e = Q - S.p
//                     I -= L U^T,   p += L e;   then I and p are added to the parent transform
//     outward         a_i = e/D - L.d,   d += S a_i;   then d is passed to the child transforms
//
// J is the armature: the diagonal part of M that no body contributes. Q is the sum of all other
// generalised forces. I is the articulated inertia [A H; H^T M] of (angular; linear) motion about
// the origin of the transform:
//
//     turn            A_p = R A R^T,   H_p = R H R^T,   M_p = R M R^T
//     translation     M_p = M,   H_p = H + [p]x M,   A_p = A + [p]x H_p^T - H [p]x
//
// The velocities of one transform (three for a rotation) are eliminated one by one, the last first.
// So the D are the pivots of M = L D L^T, eliminated from the last velocity to the first.
// Featherstone, Rigid Body Dynamics Algorithms (2008), chapter 7, with d instead of his
// accelerations: a0 contains the velocity products, so I is never multiplied by velocity products.
#pragma once

#include <optional>
#include <vector>

#include "derive/tree/composite.hpp"

namespace elgen {

/// The transform that a velocity moves, and the unit twist S in the child frame of the transform.
struct TreeJoint {
  std::uint32_t transform = 0;
  Twist unit_twist = {};
};

/// The joint of each velocity. None if a velocity moves no transform or several transforms, if a
/// velocity precedes a velocity of an ancestor transform, or if a quaternion that is no rotation
/// moves.
[[nodiscard]] std::optional<std::vector<TreeJoint>> tree_joints(KinematicTree& tree);

struct ArticulatedMotion {
  RealVector acceleration;
  RealVector pivots;    ///< D
  RealVector diagonal;  ///< of M; empty without `has_diagonal`
};

/// Solves M a = Q - (inertial forces at a = 0) + (weights) for the bodies in frames. `forces` is Q
/// and `armatures` J, by velocity. Throws ZeroPivot with is_diagonal = false: M_ii is unknown.
[[nodiscard]] ArticulatedMotion articulated_motion(KinematicTree& tree,
                                                   const std::vector<TreeJoint>& joints,
                                                   const RealVector& forces,
                                                   const RealVector& armatures, bool has_diagonal);

/// The number of operations of the factorisation M = L D L^T from the leaves to the root: the sum
/// of d (d + 2) over all velocities. d is the number of velocities between a velocity and the root.
/// Only entries of M between two limbs are assumed to be 0.
[[nodiscard]] std::size_t count_factorisation_operations(const KinematicTree& tree,
                                                         const std::vector<TreeJoint>& joints);

}  // namespace elgen
