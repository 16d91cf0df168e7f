// The part of the momentum's rate that is linear in a unit twist, for everything a step carries:
//
//     B = [A 0; -[P]x 0],  per body  P = m (v + w x c),
//     A = -[w]x Sigma - (v h^T - (h.v) 1)      Sigma = 1/2 tr(I) 1 - I about the origin
//
//     turn         P_p = R P,  A_p = R A R^T
//     translation  P_p = P,    A_p = A - (P p^T - (p.P) 1)
#pragma once

#include "derive/tree/composite.hpp"
#include "derive/tree/tree_twists.hpp"

namespace elgen {

struct CompositeRate {
  ExMatrix3 a = {0, 0, 0, 0, 0, 0, 0, 0, 0};  ///< row-major
  ExVector3 momentum{0, 0, 0};
};

/// to += from, both in the same axes.
void accumulate(VectorAlgebra& algebra, const CompositeRate& from, CompositeRate& to);

/// Of every step, in the axes after it, for the bodies moving with these twists.
[[nodiscard]] std::vector<CompositeRate> composite_rates(Tree& tree,
                                                         const std::vector<Twist>& twists);

/// In the axes before the step.
[[nodiscard]] CompositeRate to_parent(Tree& tree, std::size_t step, const CompositeRate& rate);

}  // namespace elgen
