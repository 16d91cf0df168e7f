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

std::vector<MassMoment> mass_moments(Tree& tree) {
  VectorAlgebra& algebra = tree.algebra;
  std::vector<MassMoment> result(tree.size());
  for (const RigidBody& body : tree.bodies()) {
    if (!body.step) continue;
    MassMoment& total = result[*body.step];
    total.mass = algebra.define(total.mass + body.mass);
    total.moment = algebra.add(total.moment, first_moment(algebra, body));
  }
  for (std::size_t k = tree.size(); k-- > 0;) {
    const TreeStep& step = tree.step(k);
    if (!step.parent) continue;
    MassMoment& parent = result[*step.parent];
    ExVector3 moment = tree.to_parent(k, result[k].moment);
    if (step.kind == FrameStepKind::translation) {
      const ExVector3 shift = algebra.scaled(result[k].mass, step.vector);
      moment = algebra.add(moment, shift);
    }
    parent.mass = algebra.define(parent.mass + result[k].mass);
    parent.moment = algebra.add(parent.moment, moment);
  }
  return result;
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
    ExVector3 moment = tree.to_parent(k, carried[k].moment);
    if (tree.step(k).kind == FrameStepKind::translation) {
      const ExVector3 shift = algebra.scaled(carried[k].mass, tree.step(k).vector);
      moment = algebra.add(moment, shift);
    }
    terms.push_back(-algebra.dot(g, moment));
  }
  return terms;
}

}  // namespace elgen
