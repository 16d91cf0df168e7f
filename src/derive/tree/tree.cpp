// Transforms along the tree. Sine and cosine of a constant quarter turn are numbers, so that it
// only permutes components.
#include "derive/tree/tree.hpp"

namespace elgen {

using GiNaC::ex;

namespace {

/// The coordinate axis parallel to a unit vector, and its sign; none if no axis is parallel.
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

StepRotation rotation_of(Definitions& definitions, const TreeStep& step) {
  StepRotation rotation;
  if (step.kind == FrameStepKind::translation) return rotation;
  rotation.kind = StepRotation::Kind::matrix;
  if (step.kind == FrameStepKind::quaternion) {
    rotation.entries = quaternion_matrix(step.quaternion);
    const ex scale = step.rotation ? ex(1) : define(definitions, squared_length(step.quaternion));
    for (ex& entry : rotation.entries) entry = define(definitions, entry / scale);
    return rotation;
  }
  const ex cosine = define(definitions, GiNaC::cos(step.angle));
  const ex sine = define(definitions, GiNaC::sin(step.angle));
  if (const auto axis = coordinate_axis(step.vector)) {
    rotation.kind = StepRotation::Kind::about_axis;
    rotation.axis = axis->first;
    rotation.cosine = cosine;
    rotation.sine = axis->second * sine;
    return rotation;
  }
  rotation.entries = turn_matrix(step.vector, cosine, sine);
  for (ex& entry : rotation.entries) entry = define(definitions, entry);
  return rotation;
}

/// `step` and its ancestors; empty for the world.
std::vector<std::uint32_t> path_to_root(const FrameTree& tree, std::optional<std::uint32_t> step) {
  std::vector<std::uint32_t> path;
  for (; step; step = tree.steps[*step].parent) path.push_back(*step);
  return path;
}

}  // namespace

Tree& tree_of(Derivation& derivation) {
  if (!derivation.tree_) derivation.tree_ = std::make_shared<Tree>(derivation);
  return *derivation.tree_;
}

Tree::Tree(Derivation& derivation) : algebra(derivation.definitions), derivation_(derivation) {
  for (const TreeStep& step : frames().steps) {
    rotations_.push_back(rotation_of(derivation.definitions, step));
  }
  bodies_ = regrouped(*this);
}

ExVector3 first_moment(VectorAlgebra& algebra, const RigidBody& body) {
  return body.moment ? *body.moment : algebra.scaled(body.mass, body.com);
}

void accumulate(VectorAlgebra& algebra, const SpatialForce& from, SpatialForce& to) {
  {
    const Telling force = algebra.telling("force");
    to.force = algebra.add(to.force, from.force);
  }
  const Telling moment = algebra.telling("moment");
  to.moment = algebra.add(to.moment, from.moment);
}

void append(TreeForces& to, const TreeForces& from) {
  append(to.pulled_back, from.pulled_back);
  auto& all = to.on_velocities;
  all.insert(all.end(), from.on_velocities.begin(), from.on_velocities.end());
}

Vector by_velocities(Derivation& derivation, const TreeForces& forces) {
  Vector result = derivation.by_position(forces.pulled_back);
  for (const auto& [velocity, force] : forces.on_velocities) result[velocity] += force;
  return result;
}

ExVector3 Tree::rotated(const StepRotation& r, const ExVector3& x) {
  if (r.kind == StepRotation::Kind::none) return x;
  if (r.kind == StepRotation::Kind::matrix) return algebra.product(r.entries, x);
  const auto& [axis, i, j] = cyclic_axes[r.axis];
  ExVector3 result = x;
  result[i] = r.cosine * x[i] - r.sine * x[j];
  result[j] = r.sine * x[i] + r.cosine * x[j];
  return algebra.define(result);
}

ExVector3 Tree::turned(const ExVector3& x, std::optional<std::uint32_t> from,
                       std::optional<std::uint32_t> to) {
  std::vector<std::uint32_t> up = path_to_root(frames(), from);
  std::vector<std::uint32_t> down = path_to_root(frames(), to);
  while (!up.empty() && !down.empty() && up.back() == down.back()) {
    up.pop_back();
    down.pop_back();
  }
  ExVector3 result = x;
  for (const std::uint32_t step : up) result = to_parent(step, result);
  for (auto step = down.rbegin(); step != down.rend(); ++step) result = to_child(*step, result);
  return result;
}

ExVector3 Tree::relative_spin(std::size_t index, Tangent& along) {
  const TreeStep& s = step(index);
  if (s.kind == FrameStepKind::translation) return {0, 0, 0};
  if (s.kind == FrameStepKind::turn)
    return algebra.scaled(algebra.define(along(s.angle)), s.vector);
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

void Tree::weigh(std::size_t index, const SpatialForce& on_step, TreeForces& forces) {
  const TreeStep& s = step(index);
  const Telling joint = telling("joint", index);
  switch (s.kind) {
    case FrameStepKind::translation:
      for (std::size_t i = 0; i < 3; ++i)
        forces.pulled_back.push_back({s.vector[i], on_step.force[i]});
      return;
    case FrameStepKind::turn:
      forces.pulled_back.push_back({s.angle, algebra.dot(s.vector, on_step.moment)});
      return;
    case FrameStepKind::quaternion:
      break;
  }
  if (s.rotation) {
    for (std::uint32_t i = 0; i < 3; ++i) {
      forces.on_velocities.emplace_back(*s.rotation + i, on_step.moment[i]);
    }
    return;
  }
  // The transpose of relative_spin(): n.spin = sum over i of force_i dq_i/dt.
  const std::array<ex, 4>& q = s.quaternion;
  const ExVector3& n = on_step.moment;
  const ex scale = algebra.define(2 / squared_length(q));
  const ex scalar = algebra.define(-(q[1] * n[0] + q[2] * n[1] + q[3] * n[2]));
  forces.pulled_back.push_back({q[0], algebra.define(scale * scalar)});
  for (const auto& [i, j, k] : cyclic_axes) {
    const ex component = algebra.define(q[0] * n[i] + q[j + 1] * n[k] - q[k + 1] * n[j]);
    forces.pulled_back.push_back({q[i + 1], algebra.define(scale * component)});
  }
}

SpatialForce Tree::before(std::size_t index, const SpatialForce& force) {
  SpatialForce result;
  {
    const Telling of_force = algebra.telling("force");
    result.force = to_parent(index, force.force);
  }
  const Telling of_moment = algebra.telling("moment");
  result.moment = to_parent(index, force.moment);
  if (step(index).kind == FrameStepKind::translation) {
    const ExVector3 lever = algebra.cross(step(index).vector, result.force);
    result.moment = algebra.add(result.moment, lever);
  }
  return result;
}

std::vector<SpatialForce> Tree::carried(std::vector<SpatialForce> on_step) {
  return with_carried(*this, std::move(on_step), [this](std::size_t k, const SpatialForce& force) {
    return before(k, force);
  });
}

TreeForces Tree::pull_back(std::vector<SpatialForce> on_step) {
  on_step = carried(std::move(on_step));
  TreeForces forces;
  for (std::size_t k = size(); k-- > 0;) weigh(k, on_step[k], forces);
  return forces;
}

TreeForces Tree::wrench_forces(const std::function<ex(const ex&)>& part) {
  std::vector<Wrench> wrenches = frames().wrenches;
  for (Wrench& wrench : wrenches) {
    for (ex& component : wrench.force) component = part(component);
    for (ex& component : wrench.moment) component = part(component);
  }
  const Telling of_wrenches = algebra.telling("wrench");
  std::vector<SpatialForce> on_step(size());
  for (const Wrench& wrench : wrenches) {
    if (!wrench.step) continue;
    const Telling on_frame = telling("", *wrench.step);
    const ExVector3 force = turned(wrench.force, wrench.axes, wrench.step);
    const ExVector3 pure = turned(wrench.moment, wrench.axes, wrench.step);
    const ExVector3 lever = algebra.cross(wrench.at, force);
    SpatialForce& total = on_step[*wrench.step];
    total.force = algebra.add(total.force, force);
    total.moment = algebra.add(total.moment, algebra.add(pure, lever));
  }
  return pull_back(std::move(on_step));
}

}  // namespace elgen
