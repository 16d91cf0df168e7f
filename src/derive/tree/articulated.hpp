// Articulated bodies: M a = Q for bodies in frames without M, linear in the number of steps. Where
// every velocity moves one step of the tree by its unit twist S, in the axes after the step:
//
//     a = a0 + d      a0: accelerations at a = 0, less gravity;   p: forces at a0
//     inward          U = I S,   D = S.U + J,   L = U/D,   e = Q - S.p
//                     I -= L U^T,   p += L e;   I and p are then added to what carries the step
//     outward         a_i = e/D - L.d,   d += S a_i;   d is then that of all the step carries
//
// J: what M has on its diagonal beside the bodies; Q: all other generalized forces. I is the
// articulated inertia [A H; H^T M] of (angular; linear) motion about the origin of the step:
//
//     turn            A_p = R A R^T,   H_p = R H R^T,   M_p = R M R^T
//     translation     M_p = M,   H_p = H + [p]x M,   A_p = A + [p]x H_p^T - H [p]x
//
// Velocities of one step come one after another, the last first, which is L D L^T of its D (3 x 3
// of a rotation). So the D are the pivots of M = L D L^T, eliminated from the last velocity to the
// first. Featherstone, Rigid Body Dynamics Algorithms (2008), chapter 7, with d in the place of his
// accelerations: the products of velocities are in a0, and no I times them is needed.
#pragma once

#include <optional>
#include <vector>

#include "derive/tree/composite.hpp"

namespace elgen {

/// A velocity and the step that it moves: S, in the axes after the step.
struct TreeJoint {
  std::uint32_t step = 0;
  Twist unit = {};
};

/// One for every velocity. None where a velocity moves no step or several, or where it comes before
/// one that carries it.
[[nodiscard]] std::optional<std::vector<TreeJoint>> tree_joints(Tree& tree);

struct ArticulatedMotion {
  Vector acceleration;
  Vector pivots;    ///< D
  Vector diagonal;  ///< of M; empty where it is not asked for
};

/// The solution of M a = Q less the inertial forces at a = 0 and the weights of the bodies;
/// `forces` are Q, `armatures` J, by velocity. Throws ZeroPivot, of
/// which it does not know M_ii.
[[nodiscard]] ArticulatedMotion articulated_motion(Tree& tree, const std::vector<TreeJoint>& joints,
                                                   const Vector& forces, const Vector& armatures,
                                                   bool has_diagonal);

/// Operations of the factorisation M = L D L^T alone, limbs first, where an entry of M is 0 only
/// between two limbs: d (d + 2) for every velocity that d others carry.
[[nodiscard]] std::size_t operations_of_factorisation(const Tree& tree,
                                                      const std::vector<TreeJoint>& joints);

}  // namespace elgen
