// The frames of a model as a tree of elementary motions, and what moves with them.
#pragma once

#include "elgen/lagrangian.hpp"
#include "formulate/expressions.hpp"

namespace elgen {

/// Fills lagrangian.tree and the twists of its outputs. Steps that move nothing are left out, and
/// so are frames that carry no body, torque, force or output. Where the energies are expanded the
/// tree is for outputs only. Errors are those of the translation.
void add_frame_tree(const Model& model, Translation& translation, Lagrangian& lagrangian);

}  // namespace elgen
