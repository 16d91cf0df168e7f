// Weights by the first moments of what every step carries.
#include "derive/tree/tree_gravity.hpp"

#include "derive/tree/tree_twists.hpp"

namespace elgen {

using GiNaC::ex;

namespace {

/// Gravity in the axes after every step.
std::vector<ExVector3> gravity_by_step(Tree& tree) {
  const ExVector3& g = *tree.derivation().lagrangian.gravity;
  std::vector<ExVector3> result;
  for (std::size_t k = 0; k < tree.size(); ++k) {
    const auto& parent = tree.step(k).parent;
    result.push_back(tree.to_child(k, parent ? result[*parent] : g));
  }
  return result;
}

/// Mass and first moment of what a step carries, in the axes after it.
struct MassMoment {
  ex mass = 0;
  ExVector3 moment{0, 0, 0};
};

void accumulate(VectorAlgebra& algebra, const MassMoment& from, MassMoment& to) {
  to.mass = algebra.define(to.mass + from.mass);
  to.moment = algebra.add(to.moment, from.moment);
}

/// About the origin before the step, in the axes there.
MassMoment to_parent(Tree& tree, std::size_t index, const MassMoment& c) {
  MassMoment result{c.mass, tree.to_parent(index, c.moment)};
  const TreeStep& step = tree.step(index);
  if (step.kind == FrameStepKind::translation) {
    result.moment = tree.algebra.add(result.moment, tree.algebra.scaled(c.mass, step.vector));
  }
  return result;
}

std::vector<MassMoment> mass_moments(Tree& tree) {
  auto own = on_steps<MassMoment>(tree, [&](const RigidBody& body) {
    return MassMoment{body.mass, first_moment(tree.algebra, body)};
  });
  return with_carried(tree, std::move(own), [&](std::size_t k, const MassMoment& carried) {
    return to_parent(tree, k, carried);
  });
}

}  // namespace

TreeForces tree_gravity(Tree& tree) {
  TreeForces forces;
  if (!tree.derivation().lagrangian.gravity) return forces;
  const std::vector<ExVector3> g = gravity_by_step(tree);
  const std::vector<MassMoment> carried = mass_moments(tree);
  VectorAlgebra& algebra = tree.algebra;
  for (std::size_t k = 0; k < tree.size(); ++k) {
    // -(weight) and its moment about the origin of the step.
    SpatialForce lift;
    lift.force = algebra.scaled(-carried[k].mass, g[k]);
    lift.moment = algebra.cross(g[k], carried[k].moment);
    tree.weigh(k, lift, forces);
  }
  return forces;
}

Terms tree_potential_energy(Tree& tree) {
  Terms terms;
  if (!tree.derivation().lagrangian.gravity || tree.bodies().empty()) return terms;
  VectorAlgebra& algebra = tree.algebra;
  const ExVector3 g = *tree.derivation().lagrangian.gravity;
  const std::vector<MassMoment> carried = mass_moments(tree);
  for (const RigidBody& body : tree.bodies()) {
    if (!body.step) terms.push_back(-algebra.dot(g, first_moment(algebra, body)));
  }
  for (std::size_t k = 0; k < tree.size(); ++k) {
    if (tree.step(k).parent) continue;
    terms.push_back(-algebra.dot(g, to_parent(tree, k, carried[k]).moment));
  }
  return terms;
}

}  // namespace elgen
