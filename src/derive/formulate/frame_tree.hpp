// The frames of a model as a tree of elementary motions, and what moves with them.
#pragma once

#include "derive/formulate/expressions.hpp"
#include "elgen/lagrangian.hpp"

namespace elgen {

/// Whether energies and forces are sums in the world, as an expansion and R need them.
[[nodiscard]] inline bool sums_energies(const Model& model) {
  return model.approximation.has_value() || !model.cyclic.empty();
}

/// Fills lagrangian.tree and the twists of its outputs. Steps that move nothing are left out, and
/// so are frames that carry no body, torque, force or output. Where the energies are sums the tree
/// is for outputs only. Errors are those of the translation.
void add_frame_tree(const Model& model, Translation& translation, Lagrangian& lagrangian);

}  // namespace elgen
