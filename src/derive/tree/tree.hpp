// KinematicTree: passes vectors, twists and forces along the frames of a Lagrangian.
//
// A transform is an elementary transform x_parent = R x + p from its child frame to its parent
// frame; R or p is trivial. Vectors on a transform are expressed in its child frame. A rotation
// about a coordinate axis costs four products, a constant quarter turn none.
#pragma once

#include <functional>
#include <optional>
#include <utility>
#include <vector>

#include "derive/lagrangian/derivation.hpp"
#include "derive/lagrangian/vector_algebra.hpp"

namespace elgen {

/// R of a transform: the identity, a rotation about coordinate axis `axis` by its cosine and sine,
/// or a full matrix.
struct TransformRotation {
  enum class Kind : unsigned char { none, about_axis, matrix };
  Kind kind = Kind::none;
  std::size_t axis = 2;
  GiNaC::ex cosine = 1;
  GiNaC::ex sine = 0;
  ExMatrix3 entries;

  /// R^T
  [[nodiscard]] TransformRotation inverse() const {
    return {kind, axis, cosine, -sine, transposed(entries)};
  }
};

/// A wrench on a transform: force, and moment about the origin of the transform's child frame.
struct SpatialForce {
  ExVector3 force{0, 0, 0};
  ExVector3 moment{0, 0, 0};
};

/// to += from, both in the same frame.
void accumulate(VectorAlgebra& algebra, const SpatialForce& from, SpatialForce& to);

/// Generalised forces: on angles and offsets x (`on_variables`, to be multiplied by dx/dq), and on
/// the velocities of rotations.
struct TreeForces {
  std::vector<WeightedTerm> on_variables = {};
  std::vector<std::pair<std::uint32_t, GiNaC::ex>> on_velocities = {};
};

void append(TreeForces& to, const TreeForces& from);

/// One generalised force per velocity: N^T sum weight dx/dq (dq/dt = N v), plus `on_velocities`.
[[nodiscard]] RealVector generalised_forces(Derivation& derivation, const TreeForces& forces);

class KinematicTree {
 public:
  explicit KinematicTree(Derivation& derivation);

  [[nodiscard]] Derivation& derivation() const { return derivation_; }
  [[nodiscard]] const FrameTree& frames() const { return derivation_.lagrangian.tree; }
  [[nodiscard]] std::size_t size() const { return frames().transforms.size(); }
  [[nodiscard]] const TreeTransform& transform(std::size_t index) const {
    return frames().transforms[index];
  }
  [[nodiscard]] const TransformRotation& rotation(std::size_t index) const {
    return rotations_[index];
  }
  [[nodiscard]] NameScope name_scope(const std::string& kind, std::size_t transform) {
    return algebra.name_scope(kind, frames().transforms[transform].name);
  }

  /// The bodies of the Lagrangian after regroup_bodies().
  [[nodiscard]] const std::vector<RigidBody>& bodies() const { return bodies_; }

  /// R x and R^T x, with R the rotation of a transform.
  [[nodiscard]] ExVector3 to_parent(std::size_t transform, const ExVector3& x) {
    return rotate(rotations_[transform], x);
  }
  [[nodiscard]] ExVector3 to_child(std::size_t transform, const ExVector3& x) {
    return rotate(rotations_[transform].inverse(), x);
  }

  /// Re-expresses a vector of the child frame of transform `from` in the child frame of transform
  /// `to`. If an index is none, the frame is the world.
  [[nodiscard]] ExVector3 change_axes(const ExVector3& x, std::optional<std::uint32_t> from,
                                      std::optional<std::uint32_t> to);

  /// Angular velocity of a transform's child frame relative to its parent frame, in the child
  /// frame, along a direction s: axis dangle/ds, or 2 (w de - dw e - e x de)/|q|^2 with q = (w, e).
  [[nodiscard]] ExVector3 relative_spin(std::size_t index, Tangent& along);

  /// Re-expresses a wrench in the parent frame of the transform, about the origin of that frame.
  [[nodiscard]] SpatialForce force_to_parent(std::size_t index, const SpatialForce& force);

  /// The total wrench on each transform's subtree, from the wrenches on single transforms.
  [[nodiscard]] std::vector<SpatialForce> subtree_wrenches(std::vector<SpatialForce> wrenches);

  /// Generalised forces on all angles, offsets and rotations, from the wrenches on single
  /// transforms.
  [[nodiscard]] TreeForces pull_back_wrenches(std::vector<SpatialForce> wrenches);

  /// Generalised forces of the wrenches of the Lagrangian. `part` is applied to every component:
  /// the substitution u = 0, or the derivative with respect to u_j.
  [[nodiscard]] TreeForces wrench_forces(const std::function<GiNaC::ex(const GiNaC::ex&)>& part);

  /// Appends the generalised forces on one transform's motion, from the total wrench on its
  /// subtree.
  void append_joint_forces(std::size_t index, const SpatialForce& wrench, TreeForces& forces);

  VectorAlgebra algebra;

 private:
  [[nodiscard]] ExVector3 rotate(const TransformRotation& r, const ExVector3& x);

  Derivation& derivation_;
  std::vector<TransformRotation> rotations_;
  std::vector<RigidBody> bodies_;
};

/// The tree of a Derivation, built at the first call.
[[nodiscard]] KinematicTree& tree_of(Derivation& derivation);

/// For each transform, the sum of of(body) over its bodies. Bodies fixed to the world are skipped.
template <class Value, class Of>
[[nodiscard]] std::vector<Value> sum_over_bodies(KinematicTree& tree,
                                                 const std::vector<RigidBody>& bodies,
                                                 const Of& of) {
  std::vector<Value> result(tree.size());
  for (const RigidBody& body : bodies) {
    if (!body.transform) continue;
    const NameScope on_step = tree.name_scope("", *body.transform);
    accumulate(tree.algebra, of(body), result[*body.transform]);
  }
  return result;
}

/// sum_over_bodies() for tree.bodies().
template <class Value, class Of>
[[nodiscard]] std::vector<Value> sum_over_bodies(KinematicTree& tree, const Of& of) {
  return sum_over_bodies<Value>(tree, tree.bodies(), of);
}

/// For each transform, the sum of the values in its subtree, from the leaves to the root.
/// to_parent(k, x) re-expresses x in the parent frame of transform k.
template <class Value, class ToParent>
[[nodiscard]] std::vector<Value> subtree_sums(KinematicTree& tree, std::vector<Value> values,
                                              const ToParent& to_parent) {
  for (std::size_t k = tree.size(); k-- > 0;) {
    const NameScope of_step = tree.name_scope("", k);
    const auto& parent = tree.transform(k).parent;
    if (parent) accumulate(tree.algebra, to_parent(k, values[k]), values[*parent]);
  }
  return values;
}

/// The bodies of the Lagrangian. Bodies with rational mass, com and inertia are regrouped into at
/// most one body per transform, about the origin of the child frame (regroup.cpp); the energies do
/// not change. Symbolic bodies are not merged, because every call would compute sums of their
/// parameters. with_lifted_masses() then moves the masses on rotations.
[[nodiscard]] std::vector<RigidBody> regroup_bodies(KinematicTree& tree);

/// The bodies, with each mass on a rotation moved to a point mass on the parent transform.
[[nodiscard]] std::vector<RigidBody> with_lifted_masses(KinematicTree& tree,
                                                        std::vector<RigidBody> bodies);

/// h = m c, or `body.moment` if it is set.
[[nodiscard]] ExVector3 first_moment(VectorAlgebra& algebra, const RigidBody& body);

}  // namespace elgen
