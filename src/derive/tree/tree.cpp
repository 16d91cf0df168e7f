// Transforms along the tree. Sine and cosine of a constant quarter turn are 0 or +-1, so that the
// turn only permutes components and changes signs.
#include "derive/tree/tree.hpp"

namespace elgen {

using GiNaC::ex;

namespace {

/// The index k and the sign in axis = +-e_k; none if `axis` is parallel to no coordinate axis.
std::optional<std::pair<std::size_t, int>> coordinate_axis(const ExVector3& axis) {
  for (const auto& [k, i, j] : cyclic_axes) {
    if (!axis[i].is_zero() || !axis[j].is_zero()) continue;
    if (axis[k].is_equal(1)) return std::pair(k, 1);
    if (axis[k].is_equal(-1)) return std::pair(k, -1);
  }
  return std::nullopt;
}

/// R = cos 1 + sin [n]x + (1 - cos) n n^T (Rodrigues)
ExMatrix3 turn_matrix(const ExVector3& n, const ex& cosine, const ex& sine) {
  const ex versine = 1 - cosine;
  ExMatrix3 r;
  for (const auto& [i, j, k] : cyclic_axes) {
    r[3 * i + i] = cosine + versine * n[i] * n[i];
    r[3 * i + j] = versine * n[i] * n[j] - sine * n[k];
    r[3 * i + k] = versine * n[i] * n[k] + sine * n[j];
  }
  return r;
}

/// |q|^2 R = (w^2 - e.e) 1 + 2 e e^T + 2 w [e]x of a quaternion q = (w, e).
ExMatrix3 quaternion_matrix(const std::array<ex, 4>& q) {
  ExMatrix3 r;
  for (const auto& [i, j, k] : cyclic_axes) {
    r[3 * i + i] = q[0] * q[0] + q[i + 1] * q[i + 1] - q[j + 1] * q[j + 1] - q[k + 1] * q[k + 1];
    r[3 * i + j] = 2 * (q[i + 1] * q[j + 1] - q[0] * q[k + 1]);
    r[3 * i + k] = 2 * (q[i + 1] * q[k + 1] + q[0] * q[j + 1]);
  }
  return r;
}

ex squared_length(const std::array<ex, 4>& q) {
  return q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3];
}

TransformRotation make_rotation(Definitions& definitions, const TreeTransform& transform) {
  TransformRotation rotation;
  if (transform.kind == TransformKind::translation) return rotation;
  rotation.kind = TransformRotation::Kind::matrix;
  if (transform.kind == TransformKind::quaternion) {
    rotation.entries = quaternion_matrix(transform.quaternion);
    const ex scale =
        transform.rotation ? ex(1) : define(definitions, squared_length(transform.quaternion));
    for (ex& entry : rotation.entries) entry = define(definitions, entry / scale);
    return rotation;
  }
  const ex cosine = define(definitions, GiNaC::cos(transform.angle));
  const ex sine = define(definitions, GiNaC::sin(transform.angle));
  if (const auto axis = coordinate_axis(transform.vector)) {
    rotation.kind = TransformRotation::Kind::about_axis;
    rotation.axis = axis->first;
    rotation.cosine = cosine;
    rotation.sine = axis->second * sine;
    return rotation;
  }
  rotation.entries = turn_matrix(transform.vector, cosine, sine);
  for (ex& entry : rotation.entries) entry = define(definitions, entry);
  return rotation;
}

/// `transform` and its ancestors; empty for the world.
std::vector<std::uint32_t> path_to_root(const FrameTree& tree,
                                        std::optional<std::uint32_t> transform) {
  std::vector<std::uint32_t> path;
  for (; transform; transform = tree.transforms[*transform].parent) path.push_back(*transform);
  return path;
}

}  // namespace

KinematicTree& tree_of(Derivation& derivation) {
  if (!derivation.tree_) derivation.tree_ = std::make_shared<KinematicTree>(derivation);
  return *derivation.tree_;
}

KinematicTree::KinematicTree(Derivation& derivation)
    : algebra(derivation.definitions), derivation_(derivation) {
  for (const TreeTransform& transform : frames().transforms) {
    rotations_.push_back(make_rotation(derivation.definitions, transform));
  }
  bodies_ = regroup_bodies(*this);
}

ExVector3 first_moment(VectorAlgebra& algebra, const RigidBody& body) {
  return body.moment ? *body.moment : algebra.scale(body.mass, body.com);
}

void accumulate(VectorAlgebra& algebra, const SpatialForce& from, SpatialForce& to) {
  {
    const NameScope force = algebra.name_scope("force");
    to.force = algebra.add(to.force, from.force);
  }
  const NameScope moment = algebra.name_scope("moment");
  to.moment = algebra.add(to.moment, from.moment);
}

void append(TreeForces& to, const TreeForces& from) {
  append_terms(to.on_variables, from.on_variables);
  auto& all = to.on_velocities;
  all.insert(all.end(), from.on_velocities.begin(), from.on_velocities.end());
}

RealVector generalised_forces(Derivation& derivation, const TreeForces& forces) {
  RealVector result = derivation.gradient_by_position(forces.on_variables);
  for (const auto& [velocity, force] : forces.on_velocities) result[velocity] += force;
  return result;
}

ExVector3 KinematicTree::rotate(const TransformRotation& r, const ExVector3& x) {
  if (r.kind == TransformRotation::Kind::none) return x;
  if (r.kind == TransformRotation::Kind::matrix) return algebra.product(r.entries, x);
  const auto& [axis, i, j] = cyclic_axes[r.axis];
  ExVector3 result = x;
  result[i] = r.cosine * x[i] - r.sine * x[j];
  result[j] = r.sine * x[i] + r.cosine * x[j];
  return algebra.define(result);
}

ExVector3 KinematicTree::change_axes(const ExVector3& x, std::optional<std::uint32_t> from,
                                     std::optional<std::uint32_t> to) {
  std::vector<std::uint32_t> up = path_to_root(frames(), from);
  std::vector<std::uint32_t> down = path_to_root(frames(), to);
  while (!up.empty() && !down.empty() && up.back() == down.back()) {
    up.pop_back();
    down.pop_back();
  }
  ExVector3 result = x;
  for (const std::uint32_t transform : up) result = to_parent(transform, result);
  for (auto transform = down.rbegin(); transform != down.rend(); ++transform)
    result = to_child(*transform, result);
  return result;
}

ExVector3 KinematicTree::relative_spin(std::size_t index, Tangent& along) {
  const TreeTransform& s = transform(index);
  if (s.kind == TransformKind::translation) return {0, 0, 0};
  if (s.kind == TransformKind::turn) return algebra.scale(algebra.define(along(s.angle)), s.vector);
  std::array<ex, 4> rate;
  for (std::size_t i = 0; i < 4; ++i) rate[i] = algebra.define(along(s.quaternion[i]));
  const ex scale = algebra.define(2 / squared_length(s.quaternion));
  ExVector3 spin;
  for (const auto& [i, j, k] : cyclic_axes) {
    spin[i] = scale * (s.quaternion[0] * rate[i + 1] - rate[0] * s.quaternion[i + 1] -
                       s.quaternion[j + 1] * rate[k + 1] + s.quaternion[k + 1] * rate[j + 1]);
  }
  return algebra.define(spin);
}

void KinematicTree::append_joint_forces(std::size_t index, const SpatialForce& wrench,
                                        TreeForces& forces) {
  const TreeTransform& s = transform(index);
  const NameScope joint = name_scope("joint", index);
  switch (s.kind) {
    case TransformKind::translation:
      for (std::size_t i = 0; i < 3; ++i)
        forces.on_variables.push_back({s.vector[i], wrench.force[i]});
      return;
    case TransformKind::turn:
      forces.on_variables.push_back({s.angle, algebra.dot(s.vector, wrench.moment)});
      return;
    case TransformKind::quaternion:
      break;
  }
  if (s.rotation) {
    for (std::uint32_t i = 0; i < 3; ++i) {
      forces.on_velocities.emplace_back(*s.rotation + i, wrench.moment[i]);
    }
    return;
  }
  // The transpose of relative_spin(): n.spin = sum over i of force_i dq_i/dt.
  const std::array<ex, 4>& q = s.quaternion;
  const ExVector3& n = wrench.moment;
  const ex scale = algebra.define(2 / squared_length(q));
  const ex scalar = algebra.define(-(q[1] * n[0] + q[2] * n[1] + q[3] * n[2]));
  forces.on_variables.push_back({q[0], algebra.define(scale * scalar)});
  for (const auto& [i, j, k] : cyclic_axes) {
    const ex component = algebra.define(q[0] * n[i] + q[j + 1] * n[k] - q[k + 1] * n[j]);
    forces.on_variables.push_back({q[i + 1], algebra.define(scale * component)});
  }
}

SpatialForce KinematicTree::force_to_parent(std::size_t index, const SpatialForce& force) {
  SpatialForce result;
  {
    const NameScope of_force = algebra.name_scope("force");
    result.force = to_parent(index, force.force);
  }
  const NameScope of_moment = algebra.name_scope("moment");
  result.moment = to_parent(index, force.moment);
  if (transform(index).kind == TransformKind::translation) {
    const ExVector3 lever = algebra.cross(transform(index).vector, result.force);
    result.moment = algebra.add(result.moment, lever);
  }
  return result;
}

std::vector<SpatialForce> KinematicTree::subtree_wrenches(std::vector<SpatialForce> wrenches) {
  return subtree_sums(*this, std::move(wrenches), [this](std::size_t k, const SpatialForce& force) {
    return force_to_parent(k, force);
  });
}

TreeForces KinematicTree::pull_back_wrenches(std::vector<SpatialForce> wrenches) {
  wrenches = subtree_wrenches(std::move(wrenches));
  TreeForces forces;
  for (std::size_t k = size(); k-- > 0;) append_joint_forces(k, wrenches[k], forces);
  return forces;
}

TreeForces KinematicTree::wrench_forces(const std::function<ex(const ex&)>& part) {
  std::vector<Wrench> wrenches = frames().wrenches;
  for (Wrench& wrench : wrenches) {
    for (ex& component : wrench.force) component = part(component);
    for (ex& component : wrench.moment) component = part(component);
  }
  const NameScope of_wrenches = algebra.name_scope("wrench");
  std::vector<SpatialForce> on_step(size());
  for (const Wrench& wrench : wrenches) {
    if (!wrench.transform) continue;
    const NameScope on_frame = name_scope("", *wrench.transform);
    const ExVector3 force = change_axes(wrench.force, wrench.axes, wrench.transform);
    const ExVector3 pure = change_axes(wrench.moment, wrench.axes, wrench.transform);
    const ExVector3 lever = algebra.cross(wrench.at, force);
    SpatialForce& total = on_step[*wrench.transform];
    total.force = algebra.add(total.force, force);
    total.moment = algebra.add(total.moment, algebra.add(pure, lever));
  }
  return pull_back_wrenches(std::move(on_step));
}

}  // namespace elgen
