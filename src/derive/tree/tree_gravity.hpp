// Weights of bodies in frames, each linear in the number of steps: with mu the mass and h the first
// moment of all that a step carries, in the axes after it, and g the gravity there,
//
//     parent   mu_p += mu,   h_p += R h + mu p
//     weight   F = -mu g,    N = g x h        (on the side of M a)
//
// pulled back as the component along each step.
#pragma once

#include "derive/tree/tree.hpp"

namespace elgen {

/// dV/dq of the bodies' weights, from the first moments of subtrees.
[[nodiscard]] TreeForces tree_gravity(Tree& tree);

/// -m gravity.p of each body.
[[nodiscard]] Terms tree_potential_energy(Tree& tree);

}  // namespace elgen
