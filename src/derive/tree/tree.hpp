// Tree: how vectors, rates and forces pass along the frames of a Lagrangian.
//
// A step takes x_parent = R x + p; either R or p is trivial. Vectors are kept in the axes after
// their step. Turns about a coordinate axis cost four products, quarter turns none.
#pragma once

#include <functional>
#include <optional>
#include <utility>
#include <vector>

#include "derive/lagrangian/derivation.hpp"
#include "derive/lagrangian/vector_algebra.hpp"

namespace elgen {

/// The orientation of a step. About coordinate axis `axis` by cosine and sine, or as a matrix.
struct StepRotation {
  enum class Kind : unsigned char { none, about_axis, matrix };
  Kind kind = Kind::none;
  std::size_t axis = 2;
  GiNaC::ex cosine = 1;
  GiNaC::ex sine = 0;
  ExMatrix3 entries;

  /// R^T
  [[nodiscard]] StepRotation reversed() const {
    return {kind, axis, cosine, -sine, transposed(entries)};
  }
};

/// Force and moment about the origin, in the axes after a step.
struct SpatialForce {
  ExVector3 force{0, 0, 0};
  ExVector3 moment{0, 0, 0};
};

/// Adds one force on a step to another.
void accumulate(VectorAlgebra& algebra, const SpatialForce& from, SpatialForce& to);

/// Generalized forces: weights of angles and offsets, to be pulled back to coordinates, and forces
/// on the velocities of rotations themselves.
struct TreeForces {
  std::vector<Weighted> pulled_back = {};
  std::vector<std::pair<std::uint32_t, GiNaC::ex>> on_velocities = {};
};

void append(TreeForces& to, const TreeForces& from);

/// By velocity, pulled back along every one of them.
[[nodiscard]] Vector by_velocities(Derivation& derivation, const TreeForces& forces);

class Tree {
 public:
  explicit Tree(Derivation& derivation);

  [[nodiscard]] Derivation& derivation() const { return derivation_; }
  [[nodiscard]] const FrameTree& frames() const { return derivation_.lagrangian.tree; }
  [[nodiscard]] std::size_t size() const { return frames().steps.size(); }
  [[nodiscard]] const TreeStep& step(std::size_t index) const { return frames().steps[index]; }
  [[nodiscard]] const StepRotation& rotation(std::size_t index) const { return rotations_[index]; }
  [[nodiscard]] Telling telling(const std::string& kind, std::size_t step) {
    return algebra.telling(kind, frames().steps[step].name);
  }

  /// Bodies of the Lagrangian, with numbers regrouped (regrouped()).
  [[nodiscard]] const std::vector<RigidBody>& bodies() const { return bodies_; }

  /// R x and R^T x of a step.
  [[nodiscard]] ExVector3 to_parent(std::size_t step, const ExVector3& x) {
    return rotated(rotations_[step], x);
  }
  [[nodiscard]] ExVector3 to_child(std::size_t step, const ExVector3& x) {
    return rotated(rotations_[step].reversed(), x);
  }

  /// Components after `from` (none: the world) as components after `to`.
  [[nodiscard]] ExVector3 turned(const ExVector3& x, std::optional<std::uint32_t> from,
                                 std::optional<std::uint32_t> to);

  /// Angular velocity of a step relative to its parent, in the axes after it, along a direction of
  /// motion: axis dangle/ds, or 2 (w de - dw e - e x de)/|q|^2.
  [[nodiscard]] ExVector3 relative_spin(std::size_t index, Tangent& along);

  /// Moves a force before a step: to the axes and the origin of its parent.
  [[nodiscard]] SpatialForce before(std::size_t index, const SpatialForce& force);

  /// The force on everything that a step carries, from the force on each step.
  [[nodiscard]] std::vector<SpatialForce> carried(std::vector<SpatialForce> on_step);

  /// Weighs every angle and offset by what works on it.
  [[nodiscard]] TreeForces pull_back(std::vector<SpatialForce> on_step);

  /// The generalized forces of a part of every component of the wrenches.
  [[nodiscard]] TreeForces wrench_forces(const std::function<GiNaC::ex(const GiNaC::ex&)>& part);

  /// The part of pull_back at one step.
  void weigh(std::size_t index, const SpatialForce& on_step, TreeForces& forces);

  VectorAlgebra algebra;

 private:
  [[nodiscard]] ExVector3 rotated(const StepRotation& r, const ExVector3& x);

  Derivation& derivation_;
  std::vector<StepRotation> rotations_;
  std::vector<RigidBody> bodies_;
};

/// The tree of a Derivation, made on first demand.
[[nodiscard]] Tree& tree_of(Derivation& derivation);

/// The sum on every step of what `of` makes of bodies there.
template <class Value, class Of>
[[nodiscard]] std::vector<Value> on_steps(Tree& tree, const std::vector<RigidBody>& bodies,
                                          const Of& of) {
  std::vector<Value> result(tree.size());
  for (const RigidBody& body : bodies) {
    if (!body.step) continue;
    const Telling on_step = tree.telling("", *body.step);
    accumulate(tree.algebra, of(body), result[*body.step]);
  }
  return result;
}

/// The same of all bodies of the tree.
template <class Value, class Of>
[[nodiscard]] std::vector<Value> on_steps(Tree& tree, const Of& of) {
  return on_steps<Value>(tree, tree.bodies(), of);
}

/// With what every step carries: `before` moves a value before a step, leaves first.
template <class Value, class Before>
[[nodiscard]] std::vector<Value> with_carried(Tree& tree, std::vector<Value> values,
                                              const Before& before) {
  for (std::size_t k = tree.size(); k-- > 0;) {
    const Telling of_step = tree.telling("", k);
    const auto& parent = tree.step(k).parent;
    if (parent) accumulate(tree.algebra, before(k, values[k]), values[*parent]);
  }
  return values;
}

/// The bodies of the Lagrangian; those whose mass, com and inertia are numbers, merged and
/// regrouped: at most one for each step, about its origin. The energies are the same functions of
/// the state. Symbolic bodies stay as they are (sums of their parameters would be paid in every
/// call), but for masses that move with a rotation.
[[nodiscard]] std::vector<RigidBody> regrouped(Tree& tree);

/// Bodies with the masses that move with a rotation taken to before it.
[[nodiscard]] std::vector<RigidBody> with_lifted_masses(Tree& tree, std::vector<RigidBody> bodies);

/// h = m c, or what the body was given.
[[nodiscard]] ExVector3 first_moment(VectorAlgebra& algebra, const RigidBody& body);

}  // namespace elgen
