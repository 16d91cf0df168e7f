// Forward over the tree for twists; momenta and energies body by body.
#include "derive/tree/tree_twists.hpp"

#include <algorithm>

#include "derive/tree/composite.hpp"

namespace elgen {

using GiNaC::ex;

namespace {

const ex half = GiNaC::numeric(1, 2);

/// I w about the point the inertia is about.
ExVector3 spin_momentum(VectorAlgebra& algebra, const RigidBody& body, const ExVector3& w) {
  if (body.inertia.empty()) return {0, 0, 0};
  Symmetric3 inertia;
  std::copy(body.inertia.begin(), body.inertia.end(), inertia.begin());
  return product(algebra, inertia, w);
}

}  // namespace

/// Spin of step k itself: the velocities of a rotation where it moves, else the rate of the turn.
ExVector3 own_spin(Tree& tree, std::size_t k, Tangent& along) {
  const auto& rotation = tree.step(k).rotation;
  if (!rotation) return tree.relative_spin(k, along);
  if (along(tree.step(k).quaternion[0]).is_zero()) return {0, 0, 0};
  const auto& v = tree.derivation().symbols.v;
  return {v[*rotation], v[*rotation + 1], v[*rotation + 2]};
}

bool has_mass(const RigidBody& body) {
  return !body.mass.is_zero() || (body.moment && !is_zero(*body.moment));
}

ExVector3 momentum_of(VectorAlgebra& algebra, const RigidBody& body, const Twist& twist) {
  if (body.about_origin) {
    const ExVector3 linear = algebra.scaled(body.mass, twist.velocity);
    const ExVector3 turning = algebra.cross(twist.spin, first_moment(algebra, body));
    return algebra.add(linear, turning);
  }
  const ExVector3 carried = algebra.cross(twist.spin, body.com);
  return algebra.scaled(body.mass, algebra.add(twist.velocity, carried));
}

std::vector<Twist> tree_twists(Tree& tree, Tangent& along) {
  VectorAlgebra& algebra = tree.algebra;
  std::vector<Twist> twists;
  for (std::size_t k = 0; k < tree.size(); ++k) {
    const TreeStep& step = tree.step(k);
    const Twist from = step.parent ? twists[*step.parent] : Twist{};
    Twist twist = from;
    if (step.kind == FrameStepKind::translation) {
      const ExVector3 rate = algebra.rate(step.vector, along);
      const ExVector3 carried = algebra.cross(from.spin, step.vector);
      twist.velocity = algebra.add(from.velocity, algebra.add(carried, rate));
    } else {
      const ExVector3 own = own_spin(tree, k, along);
      twist.spin = algebra.add(tree.to_child(k, from.spin), own);
      twist.velocity = tree.to_child(k, from.velocity);
    }
    twists.push_back(twist);
  }
  return twists;
}

TreeForces tree_momentum(Tree& tree) {
  VectorAlgebra& algebra = tree.algebra;
  const std::vector<Twist> twists = tree_twists(tree, tree.derivation().coasting);
  return tree.pull_back(on_steps<SpatialForce>(tree, [&](const RigidBody& body) {
    const Twist& twist = twists[*body.step];
    // Momentum about the com, so the inertia has to be about it too.
    SpatialForce momentum;
    momentum.moment = spin_momentum(algebra, body, twist.spin);
    momentum.force = momentum_of(algebra, body, twist);
    const ExVector3 lever = body.about_origin
                                ? algebra.cross(first_moment(algebra, body), twist.velocity)
                                : algebra.cross(body.com, momentum.force);
    momentum.moment = algebra.add(momentum.moment, lever);
    return momentum;
  }));
}

Terms tree_kinetic_energy(Tree& tree, Tangent& along) {
  VectorAlgebra& algebra = tree.algebra;
  const std::vector<Twist> twists = tree_twists(tree, along);
  Terms terms;
  for (const RigidBody& body : tree.bodies()) {
    if (!body.step) continue;
    const Twist& twist = twists[*body.step];
    const ExVector3 spin = spin_momentum(algebra, body, twist.spin);
    terms.push_back(half * algebra.dot(spin, twist.spin));
    if (!has_mass(body)) continue;
    if (body.about_origin) {
      // 1/2 m v_O^2 + v_O.(w x h), the rest is in the inertia.
      const ExVector3 turning = algebra.cross(twist.spin, first_moment(algebra, body));
      const ExVector3 linear = algebra.scaled(half * body.mass, twist.velocity);
      terms.push_back(algebra.dot(twist.velocity, algebra.add(linear, turning)));
    } else {
      const ExVector3 carried = algebra.cross(twist.spin, body.com);
      const ExVector3 velocity = algebra.add(twist.velocity, carried);
      terms.push_back(half * body.mass * algebra.dot(velocity, velocity));
    }
  }
  return terms;
}

}  // namespace elgen
