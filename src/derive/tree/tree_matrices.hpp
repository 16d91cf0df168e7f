// Mass matrix, Coriolis matrix and derivatives of inverse dynamics of bodies in frames, by
// composite inertias.
//
// A variable x of the tree (an angle, a component of an offset, or a velocity of a rotation) moves
// the subtree of its transform with the unit twist S. With the composites I and B of that subtree:
//
//     M_kl = S_l . (I_k S_k)                                     l an ancestor of k
//     C_lk = S_l . (I_k S'_k + B_k S_k),   C_kl = (I_k S_k) . S'_l + (B_k^T S_k) . S_l
//
// S' = twist x S is the rate of S as seen from the world. B = [A 0; -[P]x 0] is the part of the
// momentum rate that is linear in the twist, with P = m v + w x h and
// A = [Sigma w]x - I [w]x - [h]x [v]x of each body, Sigma = 1/2 tr(I) 1 - I. This C belongs to the
// Christoffel symbols; for a mass point it is m dp/dq^T d/dt(dp/dq). Echeandia, Wensing, Numerical
// Methods to Compute the Coriolis Matrix and Christoffel Symbols for Rigid-Body Systems (2021).
//
// Variables x(q, t) are mapped to coordinates by J = dx/dq: M = J^T M_x J, and
// C = J^T (C_x J + M_x dJ/dt).
//
// A column is a wrench on the subtree of one variable, such as I_k S_k. Columns are passed towards
// the root. Products of a column and the twists of variables on the path are entries of matrices.
#pragma once

#include <functional>
#include <map>

#include "derive/tree/composite.hpp"

namespace elgen {

/// A variable of the tree, and its unit twist (spin; velocity) in the child frame of its transform.
struct TreeVariable {
  std::uint32_t transform = 0;
  ExVector3 spin{0, 0, 0};
  ExVector3 velocity{0, 0, 0};
  GiNaC::ex value = 0;                               ///< x(q, t)
  std::optional<std::uint32_t> velocity_index = {};  ///< set for a rotation, which has no x(q, t)
};

/// An entry of dx/dq, along one velocity.
struct JacobianEntry {
  std::size_t velocity = 0;
  GiNaC::ex value = 0;
};

/// Variables that depend on coordinates, by ascending transform. A quaternion given by expressions
/// of coordinates has no variables: `is_complete` is then false, and matrices are derived from
/// generalised forces.
struct TreeVariables {
  std::vector<TreeVariable> list = {};
  bool is_complete = true;
};

[[nodiscard]] TreeVariables tree_variables(const KinematicTree& tree);

/// The non-zero entries of dx/dq.
[[nodiscard]] std::vector<JacobianEntry> jacobian_row(KinematicTree& tree,
                                                      const TreeVariable& variable);

/// True if no entry of the row depends on coordinates or time.
[[nodiscard]] bool is_constant(const Definitions& definitions,
                               const std::vector<JacobianEntry>& row);

/// S is the unit twist of a variable. I and B are the composites of the subtree of its transform
/// (see the top), and f is the wrench on that subtree. v and a are the twist and acceleration of
/// the parent transform; v_own is the twist of the transform itself:
///
///     S'  = v_own x S    rate of S             R1 = v x S,   R2 = a x S + v x R1
enum class ColumnKind : unsigned char {
  inertia,      ///< I S
  rate,         ///< I S' + B S
  transposed,   ///< B^T S
  by_position,  ///< I R2 + 2 B R1 + S x* f
  by_velocity,  ///< I (R1 + S') + 2 B S
};

/// The twists of a variable. Entries of matrices are products of a column and one of these twists.
enum class TwistKind : unsigned char {
  unit,         ///< S
  rate,         ///< S'
  first_rate,   ///< R1
  second_rate,  ///< R2
};

/// The columns of variable `upper`, passed towards the root to the transform of variable `lower`,
/// in the frame of this transform's TransformQuantities. `is_mutual`: both variables belong to one
/// transform, and the pair is visited in both orders.
struct ColumnPair {
  std::size_t upper = 0;
  std::size_t lower = 0;
  bool is_mutual = false;
  const std::vector<SpatialForce>& columns;
};

class TreeColumns {
 public:
  TreeColumns(KinematicTree& tree, const std::vector<TreeVariable>& variables,
              const AccelerationTangents& by);

  /// Calls `visit` for the pairs of each variable with itself, with each other variable of its
  /// transform, and with each variable of the ancestor transforms.
  void for_each_pair(const std::vector<ColumnKind>& kinds,
                     const std::function<void(const ColumnPair&)>& visit);

  /// The scalar product of `column` and a twist of `variable`.
  [[nodiscard]] GiNaC::ex twist_product(std::size_t variable, TwistKind kind,
                                        const SpatialForce& column);

 private:
  /// Spatial quantities of a transform. They are expressed in the parent frame of the transform, or
  /// in the child frame if the transform is a rotation.
  struct TransformQuantities {
    CompositeInertia inertia = {};
    CompositeRate rate = {};
    Twist own_twist = {};             ///< of the transform itself
    Twist parent_twist = {};          ///< of the parent transform
    TransformMotion motion = {};      ///< of the parent transform
    SpatialForce subtree_force = {};  ///< on the subtree
  };

  [[nodiscard]] const TransformQuantities& quantities(const TreeVariable& variable);
  [[nodiscard]] TransformQuantities quantities_in_child_frame(std::uint32_t transform);
  [[nodiscard]] TransformQuantities quantities_in_parent_frame(std::uint32_t transform);
  void compute_motions();
  [[nodiscard]] Twist variable_twist(TwistKind kind, const TreeVariable& variable);
  [[nodiscard]] Twist twist_cross(const Twist& twist, const Twist& with);
  [[nodiscard]] Twist second_rate_twist(const TransformQuantities& quantities,
                                        const TreeVariable& variable);
  [[nodiscard]] SpatialForce column(ColumnKind kind, const TreeVariable& variable);
  [[nodiscard]] SpatialForce inertia_product(const TreeVariable& variable, const Twist& twist);
  [[nodiscard]] SpatialForce rate_product(const TreeVariable& variable, const Twist& twist);
  [[nodiscard]] SpatialForce transposed_rate_product(const TreeVariable& variable);
  void visit_ancestors(std::size_t upper, std::vector<SpatialForce> columns,
                       const std::function<void(const ColumnPair&)>& visit);

  KinematicTree& tree_;
  VectorAlgebra& algebra_;
  const std::vector<TreeVariable>& variables_;
  AccelerationTangents acceleration_;
  std::vector<std::vector<std::size_t>> variables_by_transform_;  ///< variables of each transform
  std::vector<bool> has_ancestor_variables_;  ///< true if an ancestor transform has variables
  std::vector<CompositeInertia> inertias_;
  // By transform, computed at the first use:
  std::vector<Twist> twists_;
  std::vector<CompositeRate> rates_;
  std::vector<TransformMotion> motions_;
  std::vector<SpatialForce> subtree_forces_;
  std::vector<std::optional<TransformQuantities>> quantities_;
};

/// Entries of an n_v x n_v matrix that may differ from zero, by row and column.
using SparseMatrix = std::map<std::pair<std::size_t, std::size_t>, GiNaC::ex>;

/// entries += matrix; `entries` is row-major with n columns.
void add_to_dense(const SparseMatrix& matrix, RealVector& entries, std::size_t n);

[[nodiscard]] SparseMatrix tree_mass_matrix(KinematicTree& tree);
[[nodiscard]] SparseMatrix tree_coriolis_matrix(KinematicTree& tree);

/// True if tree_variables() is complete, and dx/dq of every variable x is constant.
[[nodiscard]] bool has_linear_variables(KinematicTree& tree);

/// d tau/dq and d tau/dv of the inertial forces and weights. Requires has_linear_variables().
/// R1 = v x S and R2 = a x S + v x R1, with v and a of the parent transform. The base has the
/// acceleration -gravity:
///
///     dtau_k/dq_l = (I_k S_k).R2_l + 2 (B_k^T S_k).R1_l         l an ancestor of k, or k
///     dtau_l/dq_k = S_l.(I_k R2_k + 2 B_k R1_k + S_k x* f_k)
///     dtau_k/dv_l = (I_k S_k).(R1_l + S'_l) + 2 (B_k^T S_k).S_l
///     dtau_l/dv_k = S_l.(I_k (R1_k + S'_k) + 2 B_k S_k)
///
/// For a rotation, d/dq is the derivative along the rotation vector in its child frame. Singh,
/// Russell, Wensing, Efficient Analytical Derivatives of Rigid-Body Dynamics (2022).
struct TreeDerivatives {
  SparseMatrix by_position = {};
  SparseMatrix by_velocity = {};
};
[[nodiscard]] TreeDerivatives tree_derivatives(KinematicTree& tree, Tangent& second);

}  // namespace elgen
