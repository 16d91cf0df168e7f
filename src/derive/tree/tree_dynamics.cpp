// Twists and accelerations go from the root to the leaves, forces from the leaves to the root.
// Momenta and kinetic energies are sums over bodies; weights use first moments of subtrees.
#include "derive/tree/tree_dynamics.hpp"

#include <algorithm>

#include "derive/tree/composite.hpp"

namespace elgen {

using GiNaC::ex;

namespace {

const ex half = GiNaC::numeric(1, 2);

/// I w, about the reference point of the inertia: the com, or the origin of the transform.
ExVector3 spin_momentum(VectorAlgebra& algebra, const RigidBody& body, const ExVector3& w) {
  if (body.inertia.empty()) return {0, 0, 0};
  Symmetric3 inertia;
  std::copy(body.inertia.begin(), body.inertia.end(), inertia.begin());
  return product(algebra, inertia, w);
}

/// U = [w']x + w w^T - (w.w) 1, row-major. A point at c, fixed to the transform, has the
/// acceleration a + U c.
ExMatrix3 acceleration_gradient(VectorAlgebra& algebra, const ExVector3& w, const ExVector3& rate) {
  ExMatrix3 u;
  std::array<ex, 3> squares;
  for (std::size_t i = 0; i < 3; ++i) squares[i] = algebra.define(w[i] * w[i]);
  for (const auto& [i, j, k] : cyclic_axes) {
    const ex product = algebra.define(w[i] * w[j]);
    u[3 * i + i] = algebra.define(-squares[j] - squares[k]);
    u[3 * i + j] = algebra.define(product - rate[k]);
    u[3 * j + i] = algebra.define(product + rate[k]);
  }
  return u;
}

ExVector3 sum(const ExVector3& a, const ExVector3& b) {
  return {a[0] + b[0], a[1] + b[1], a[2] + b[2]};
}

/// I w' + w x I w, from the known entries of U. The x component is below; y and z follow by cyclic
/// permutation:
///     Ixx w'_x + (Izz - Iyy) w_y w_z - Ixy U_zx + Ixz U_yx + Iyz (U_yy - U_zz)
ExVector3 inertial_moment(VectorAlgebra& algebra, const std::vector<ex>& inertia,
                          const TransformMotion& motion) {
  static constexpr std::array<std::array<std::size_t, 3>, 3> place{
      {{0, 3, 4}, {3, 1, 5}, {4, 5, 2}}};
  const auto entry = [&](std::size_t i, std::size_t j) { return inertia[place[i][j]]; };
  const auto& u = motion.acceleration_gradient;
  ExVector3 moment;
  for (const auto& [i, j, k] : cyclic_axes) {
    const ex difference = algebra.define(entry(k, k) - entry(j, j));
    const ex stretch = algebra.define(u[3 * j + j] - u[3 * k + k]);
    moment[i] = entry(i, i) * motion.spin_rate[i] + difference * motion.spin_products[i] -
                entry(i, j) * u[3 * k + i] + entry(i, k) * u[3 * j + i] + entry(j, k) * stretch;
  }
  return algebra.define(moment);
}

class MotionRecursion {
 public:
  MotionRecursion(KinematicTree& tree, const AccelerationTangents& acceleration)
      : tree_(tree), algebra_(tree.algebra), by_(acceleration) {}

  std::vector<TransformMotion> run() {
    std::vector<TransformMotion> motions;
    for (std::size_t k = 0; k < tree_.size(); ++k) {
      const NameScope motion = tree_.name_scope("motion", k);
      const auto& parent = tree_.transform(k).parent;
      const TransformMotion from =
          parent ? motions[*parent] : base_motion(tree_, by_.includes_gravity);
      motions.push_back(tree_.transform(k).kind == TransformKind::translation
                            ? translate_motion(k, from)
                            : rotate_motion(k, from));
    }
    return motions;
  }

 private:
  TransformMotion translate_motion(std::size_t k, const TransformMotion& from) {
    const ExVector3& p = tree_.transform(k).vector;
    const ExVector3 rate = algebra_.rate(p, by_.velocity_tangent);
    const ExVector3 second_rate = algebra_.rate(rate, by_.acceleration_tangent);
    TransformMotion motion = from;
    const ExVector3 carried = algebra_.product(from.acceleration_gradient, p);
    const ExVector3 coriolis = algebra_.scale(2, algebra_.cross(from.spin, rate));
    const ExVector3 own = algebra_.add(coriolis, second_rate);
    motion.acceleration = algebra_.add(from.acceleration, algebra_.add(carried, own));
    return motion;
  }

  TransformMotion rotate_motion(std::size_t k, const TransformMotion& from) {
    const TreeTransform& transform = tree_.transform(k);
    const ExVector3 own = joint_spin(tree_, k, by_.velocity_tangent);
    const ExVector3 own_rate = algebra_.rate(own, by_.acceleration_tangent);
    TransformMotion motion;
    const ExVector3 carried = tree_.to_child(k, from.spin);
    motion.spin = algebra_.define(sum(carried, own), transform.name + "_spin", transform.origin);
    const ExVector3 carried_rate = tree_.to_child(k, from.spin_rate);
    const ExVector3 across = algebra_.cross(carried, own);
    const ExVector3 relative = algebra_.add(across, own_rate);
    motion.spin_rate = algebra_.define(sum(carried_rate, relative), transform.name + "_spin_rate",
                                       transform.origin);
    motion.acceleration = tree_.to_child(k, from.acceleration);
    motion.acceleration_gradient = acceleration_gradient(algebra_, motion.spin, motion.spin_rate);
    for (const auto& [axis, i, j] : cyclic_axes) {
      motion.spin_products[axis] = algebra_.define(motion.spin[i] * motion.spin[j]);
    }
    return motion;
  }

  KinematicTree& tree_;
  VectorAlgebra& algebra_;
  const AccelerationTangents& by_;
};

/// F and N about the origin of the transform.
SpatialForce inertial_force(VectorAlgebra& algebra, const RigidBody& body,
                            const TransformMotion& motion) {
  const NameScope inertial = algebra.name_scope("inertial");
  SpatialForce result;
  if (!body.inertia.empty()) result.moment = inertial_moment(algebra, body.inertia, motion);
  if (!has_mass(body)) return result;
  if (body.is_about_origin) {
    const ExVector3 h = first_moment(algebra, body);
    const ExVector3 own = algebra.scale(body.mass, motion.acceleration);
    result.force = algebra.add(own, algebra.product(motion.acceleration_gradient, h));
    result.moment = algebra.add(result.moment, algebra.cross(h, motion.acceleration));
    return result;
  }
  const ExVector3 carried = algebra.product(motion.acceleration_gradient, body.com);
  result.force = algebra.scale(body.mass, algebra.add(motion.acceleration, carried));
  result.moment = algebra.add(result.moment, algebra.cross(body.com, result.force));
  return result;
}

/// Gravity in the child frame of each transform.
std::vector<ExVector3> gravity_by_transform(KinematicTree& tree) {
  const ExVector3& g = *tree.derivation().lagrangian.gravity;
  std::vector<ExVector3> result;
  for (std::size_t k = 0; k < tree.size(); ++k) {
    const NameScope gravity = tree.name_scope("gravity", k);
    const auto& parent = tree.transform(k).parent;
    result.push_back(tree.to_child(k, parent ? result[*parent] : g));
  }
  return result;
}

/// Mass and first moment of a transform's subtree, in the transform's child frame.
struct MassMoment {
  ex mass = 0;
  ExVector3 moment{0, 0, 0};
};

void accumulate(VectorAlgebra& algebra, const MassMoment& from, MassMoment& to) {
  to.mass = algebra.define(to.mass + from.mass);
  to.moment = algebra.add(to.moment, from.moment);
}

/// `c` re-expressed in the parent frame of transform `index`, about the origin of the parent frame.
MassMoment to_parent(KinematicTree& tree, std::size_t index, const MassMoment& c) {
  MassMoment result{c.mass, tree.to_parent(index, c.moment)};
  const TreeTransform& transform = tree.transform(index);
  if (transform.kind == TransformKind::translation) {
    result.moment = tree.algebra.add(result.moment, tree.algebra.scale(c.mass, transform.vector));
  }
  return result;
}

std::vector<MassMoment> mass_moments(KinematicTree& tree) {
  const NameScope moments = tree.algebra.name_scope("mass");
  auto own = sum_over_bodies<MassMoment>(tree, [&](const RigidBody& body) {
    return MassMoment{body.mass, first_moment(tree.algebra, body)};
  });
  return subtree_sums(tree, std::move(own), [&](std::size_t k, const MassMoment& carried) {
    return to_parent(tree, k, carried);
  });
}

}  // namespace

ExVector3 joint_spin(KinematicTree& tree, std::size_t k, Tangent& along) {
  const auto& rotation = tree.transform(k).rotation;
  if (!rotation) return tree.relative_spin(k, along);
  if (along(tree.transform(k).quaternion[0]).is_zero()) return {0, 0, 0};
  const auto& v = tree.derivation().symbols.v;
  return {v[*rotation], v[*rotation + 1], v[*rotation + 2]};
}

bool has_mass(const RigidBody& body) {
  return !body.mass.is_zero() || (body.moment && !is_zero(*body.moment));
}

ExVector3 linear_momentum(VectorAlgebra& algebra, const RigidBody& body, const Twist& twist) {
  if (body.is_about_origin) {
    const ExVector3 linear = algebra.scale(body.mass, twist.velocity);
    const ExVector3 turning = algebra.cross(twist.spin, first_moment(algebra, body));
    return algebra.add(linear, turning);
  }
  const ExVector3 carried = algebra.cross(twist.spin, body.com);
  return algebra.scale(body.mass, algebra.add(twist.velocity, carried));
}

Twist child_twist(KinematicTree& tree, std::size_t k, const Twist& from, Tangent& along) {
  VectorAlgebra& algebra = tree.algebra;
  const NameScope velocity = tree.name_scope("velocity", k);
  const TreeTransform& transform = tree.transform(k);
  Twist twist = from;
  if (transform.kind == TransformKind::translation) {
    const ExVector3 rate = algebra.rate(transform.vector, along);
    const ExVector3 carried = algebra.cross(from.spin, transform.vector);
    twist.velocity = algebra.add(from.velocity, algebra.add(carried, rate));
  } else {
    const ExVector3 own = joint_spin(tree, k, along);
    twist.spin = algebra.add(tree.to_child(k, from.spin), own);
    twist.velocity = tree.to_child(k, from.velocity);
  }
  return twist;
}

std::vector<Twist> tree_twists(KinematicTree& tree, Tangent& along) {
  std::vector<Twist> twists;
  for (std::size_t k = 0; k < tree.size(); ++k) {
    const auto& parent = tree.transform(k).parent;
    twists.push_back(child_twist(tree, k, parent ? twists[*parent] : Twist{}, along));
  }
  return twists;
}

TreeForces tree_momentum(KinematicTree& tree) {
  VectorAlgebra& algebra = tree.algebra;
  const std::vector<Twist> twists = tree_twists(tree, tree.derivation().rate_without_acceleration);
  const NameScope momenta = algebra.name_scope("momentum");
  return tree.pull_back_wrenches(sum_over_bodies<SpatialForce>(tree, [&](const RigidBody& body) {
    const Twist& twist = twists[*body.transform];
    // If the inertia is about the com, I w is about the com too, and the lever term moves it to the
    // origin.
    SpatialForce momentum;
    momentum.moment = spin_momentum(algebra, body, twist.spin);
    momentum.force = linear_momentum(algebra, body, twist);
    const ExVector3 lever = body.is_about_origin
                                ? algebra.cross(first_moment(algebra, body), twist.velocity)
                                : algebra.cross(body.com, momentum.force);
    momentum.moment = algebra.add(momentum.moment, lever);
    return momentum;
  }));
}

Terms body_kinetic_energy(VectorAlgebra& algebra, const RigidBody& body, const Twist& twist) {
  const ExVector3 spin = spin_momentum(algebra, body, twist.spin);
  Terms terms{half * algebra.dot(spin, twist.spin)};
  if (!has_mass(body)) return terms;
  if (body.is_about_origin) {
    // T = 1/2 m v^2 + v.(w x h) + 1/2 w.I w about the origin; 1/2 w.I w is already a term.
    const ExVector3 turning = algebra.cross(twist.spin, first_moment(algebra, body));
    const ExVector3 linear = algebra.scale(half * body.mass, twist.velocity);
    terms.push_back(algebra.dot(twist.velocity, algebra.add(linear, turning)));
  } else {
    const ExVector3 carried = algebra.cross(twist.spin, body.com);
    const ExVector3 velocity = algebra.add(twist.velocity, carried);
    terms.push_back(half * body.mass * algebra.dot(velocity, velocity));
  }
  return terms;
}

Terms tree_kinetic_energy(KinematicTree& tree, Tangent& along) {
  const std::vector<Twist> twists = tree_twists(tree, along);
  Terms terms;
  for (const RigidBody& body : tree.bodies()) {
    if (!body.transform) continue;
    const NameScope energy = tree.name_scope("kinetic", *body.transform);
    const Terms own = body_kinetic_energy(tree.algebra, body, twists[*body.transform]);
    terms.insert(terms.end(), own.begin(), own.end());
  }
  return terms;
}

TransformMotion base_motion(KinematicTree& tree, bool includes_gravity) {
  TransformMotion motion;
  const auto& g = tree.derivation().lagrangian.gravity;
  if (includes_gravity && g) motion.acceleration = {-(*g)[0], -(*g)[1], -(*g)[2]};
  return motion;
}

std::vector<TransformMotion> tree_motions(KinematicTree& tree,
                                          const AccelerationTangents& acceleration) {
  return MotionRecursion(tree, acceleration).run();
}

std::vector<SpatialForce> inertial_forces_on_transforms(
    KinematicTree& tree, const std::vector<RigidBody>& bodies,
    const std::vector<TransformMotion>& motions) {
  return sum_over_bodies<SpatialForce>(tree, bodies, [&](const RigidBody& body) {
    return inertial_force(tree.algebra, body, motions[*body.transform]);
  });
}

TreeForces inertial_forces(KinematicTree& tree, const AccelerationTangents& acceleration) {
  const std::vector<TransformMotion> motions = tree_motions(tree, acceleration);
  return tree.pull_back_wrenches(inertial_forces_on_transforms(tree, tree.bodies(), motions));
}

TreeForces tree_gravity_forces(KinematicTree& tree) {
  TreeForces forces;
  if (!tree.derivation().lagrangian.gravity) return forces;
  const std::vector<ExVector3> g = gravity_by_transform(tree);
  const std::vector<MassMoment> carried = mass_moments(tree);
  VectorAlgebra& algebra = tree.algebra;
  for (std::size_t k = 0; k < tree.size(); ++k) {
    const NameScope weight = tree.name_scope("weight", k);
    // Minus the weight, and the moment of this force about the origin of the transform.
    SpatialForce lift;
    lift.force = algebra.scale(-carried[k].mass, g[k]);
    lift.moment = algebra.cross(g[k], carried[k].moment);
    tree.append_joint_forces(k, lift, forces);
  }
  return forces;
}

Terms tree_potential_energy(KinematicTree& tree) {
  Terms terms;
  if (!tree.derivation().lagrangian.gravity || tree.bodies().empty()) return terms;
  VectorAlgebra& algebra = tree.algebra;
  const ExVector3 g = *tree.derivation().lagrangian.gravity;
  const std::vector<MassMoment> carried = mass_moments(tree);
  for (const RigidBody& body : tree.bodies()) {
    if (!body.transform) terms.push_back(-algebra.dot(g, first_moment(algebra, body)));
  }
  for (std::size_t k = 0; k < tree.size(); ++k) {
    if (tree.transform(k).parent) continue;
    terms.push_back(-algebra.dot(g, to_parent(tree, k, carried[k]).moment));
  }
  return terms;
}

}  // namespace elgen
