// regroup: numbers of rigid bodies, moved to where they cost least.
#pragma once

#include "derive/tree/tree.hpp"

namespace elgen {

/// The bodies of the Lagrangian; those whose mass, com and inertia are numbers, merged and
/// regrouped: at most one for each step, about its origin. The energies are the same functions of
/// the state. Symbolic bodies stay as they are (sums of their parameters would be paid in every
/// call), but for masses that move with a rotation.
[[nodiscard]] std::vector<RigidBody> regrouped(Tree& tree);

}  // namespace elgen
