// Twists of frames, and what bodies make of them: momenta and kinetic energies, each linear in the
// number of steps. In the axes after each step, with w the angular velocity and v the velocity of
// the origin:
//
//     turn          w = R^T w_p + s,   v = R^T v_p        s: spin of the turn itself
//     translation   w = w_p,           v = v_p + w x p + p'
//     body          T = 1/2 m v_c^2 + 1/2 w.I w,   v_c = v + w x c
//
// Featherstone, Rigid Body Dynamics Algorithms (2008), chapter 2.
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

}  // namespace elgen
