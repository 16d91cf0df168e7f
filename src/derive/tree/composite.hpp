// Composite inertias: the subtree of a transform as one rigid body, expressed in the child frame of
// the transform, about the origin of this frame.
//
//     turn         h_p = R h,          I_p = R I R^T
//     translation  h_p = h + m p,      I_p = I - [p]x [h]x - [h_p]x [p]x
//
// Featherstone, Rigid Body Dynamics Algorithms (2008), chapter 6 (mass, first moment h, inertia I
// instead of 6 x 6 matrices).
#pragma once

#include "derive/tree/tree_dynamics.hpp"

namespace elgen {

/// A symmetric matrix by its entries xx yy zz xy xz yz.
using Symmetric3 = std::array<GiNaC::ex, 6>;

[[nodiscard]] std::size_t symmetric_index(std::size_t i, std::size_t j);

struct CompositeInertia {
  GiNaC::ex mass = 0;
  ExVector3 moment{0, 0, 0};
  Symmetric3 inertia{0, 0, 0, 0, 0, 0};
};

/// to += from, both in the same frame.
void accumulate(VectorAlgebra& algebra, const CompositeInertia& from, CompositeInertia& to);

/// The inertia of one body about the origin of its transform: I_c + (c.h) 1 - c h^T.
[[nodiscard]] CompositeInertia inertia_about_origin(VectorAlgebra& algebra, const RigidBody& body);

/// S x
[[nodiscard]] ExVector3 product(VectorAlgebra& algebra, const Symmetric3& s, const ExVector3& x);

/// R S R^T and R A R^T, with R the rotation of the transform.
[[nodiscard]] Symmetric3 to_parent(KinematicTree& tree, std::size_t transform, const Symmetric3& s);
[[nodiscard]] ExMatrix3 to_parent(KinematicTree& tree, std::size_t transform, const ExMatrix3& a);

/// `c` re-expressed in the parent frame of the transform, about the origin of the parent frame.
[[nodiscard]] CompositeInertia to_parent(KinematicTree& tree, std::size_t transform,
                                         const CompositeInertia& c);

/// The composite inertia of each transform's subtree, by transform.
[[nodiscard]] std::vector<CompositeInertia> composite_inertias(KinematicTree& tree);

/// I (spin; velocity): linear momentum, and angular momentum about the origin.
[[nodiscard]] SpatialForce spatial_momentum(VectorAlgebra& algebra, const CompositeInertia& inertia,
                                            const ExVector3& spin, const ExVector3& velocity);

/// B, the part of the momentum rate that is linear in a unit twist, for the subtree of a transform:
///
///     B = [A 0; -[P]x 0],  per body  P = m (v + w x c),
///     A = -[w]x Sigma - (v h^T - (h.v) 1)      Sigma = 1/2 tr(I) 1 - I about the origin
///
///     turn         P_p = R P,  A_p = R A R^T
///     translation  P_p = P,    A_p = A - (P p^T - (p.P) 1)
struct CompositeRate {
  ExMatrix3 a = {0, 0, 0, 0, 0, 0, 0, 0, 0};  ///< row-major
  ExVector3 momentum{0, 0, 0};
};

/// to += from, both in the same frame.
void accumulate(VectorAlgebra& algebra, const CompositeRate& from, CompositeRate& to);

/// `rate` re-expressed in the parent frame of the transform, about the origin of the parent frame.
[[nodiscard]] CompositeRate to_parent(KinematicTree& tree, std::size_t transform,
                                      const CompositeRate& rate);

/// B of each transform's subtree, in the transform's child frame; `twists` by transform.
[[nodiscard]] std::vector<CompositeRate> composite_rates(KinematicTree& tree,
                                                         const std::vector<Twist>& twists);

}  // namespace elgen
