// Positions, poses, energies and the power of forces, as the entries of the model define them.
#include "random/motion.hpp"

#include <algorithm>
#include <stdexcept>

namespace elgen::test::random {

namespace {

Matrix identity() { return {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}; }

/// The rotation matrix by Rodrigues' formula; `axis` may have any length except 0.
Matrix turn_about(const Vector& axis, const Jet& angle) {
  const Jet length = power(dot(axis, axis), 1, 2);
  const Vector n{axis[0] / length, axis[1] / length, axis[2] / length};
  const Jet c = call("cos", {angle});
  const Jet s = call("sin", {angle});
  const Jet rest = Jet(1) - c;
  return {{c + rest * n[0] * n[0], rest * n[0] * n[1] - s * n[2], rest * n[0] * n[2] + s * n[1]},
          {rest * n[1] * n[0] + s * n[2], c + rest * n[1] * n[1], rest * n[1] * n[2] - s * n[0]},
          {rest * n[2] * n[0] - s * n[1], rest * n[2] * n[1] + s * n[0], c + rest * n[2] * n[2]}};
}

Matrix turn_about(int letter, const Jet& angle) {
  return turn_about(Vector{letter == 0 ? 1 : 0, letter == 1 ? 1 : 0, letter == 2 ? 1 : 0}, angle);
}

/// The rotation matrix of a unit quaternion, scalar part first.
Matrix turn_by(const Vector& q) {
  const auto& [w, x, y, z] = std::tie(q[0], q[1], q[2], q[3]);
  return {{w * w + x * x - y * y - z * z, (x * y - w * z) * 2, (x * z + w * y) * 2},
          {(x * y + w * z) * 2, w * w - x * x + y * y - z * z, (y * z - w * x) * 2},
          {(x * z - w * y) * 2, (y * z + w * x) * 2, w * w - x * x - y * y + z * z}};
}

Vector unit(const Vector& q) {
  const Jet length = power(dot(q, q), 1, 2);
  Vector result;
  for (const Jet& entry : q) result.push_back(entry / length);
  return result;
}

Vector sum(Vector a, const Vector& b) {
  for (std::size_t i = 0; i < a.size(); ++i) a[i] += b[i];
  return a;
}

template <class Entries>
const auto& named(const Entries& entries, const std::string& name) {
  const auto found = std::find_if(entries.begin(), entries.end(),
                                  [&](const auto& entry) { return entry.name == name; });
  if (found == entries.end()) throw std::out_of_range("no " + name);
  return *found;
}

template <class Entries>
bool has(const Entries& entries, const std::string& name) {
  return std::any_of(entries.begin(), entries.end(),
                     [&](const auto& entry) { return entry.name == name; });
}

Matrix symmetric(const Vector& I) {
  if (I.size() == 3) return {{I[0], 0, 0}, {0, I[1], 0}, {0, 0, I[2]}};
  return {{I[0], I[3], I[4]}, {I[3], I[1], I[5]}, {I[4], I[5], I[2]}};
}

}  // namespace

const Layout::Place& Layout::place(const std::string& name) const { return named(places, name); }

Layout layout_of(const Model& model, const std::vector<Lock>& locks) {
  Layout layout;
  for (const Coordinate& coordinate : model.coordinates) {
    for (int i = 1; i <= std::max(coordinate.repeat, 1); ++i) {
      const std::string element = coordinate.repeat > 0 ? std::to_string(i) : "";
      const std::string name = indexed(coordinate.name, element);
      const auto lock = std::find_if(locks.begin(), locks.end(), [&](const Lock& candidate) {
        return candidate.coordinate == name;
      });
      layout.places.push_back({name, layout.q_count, layout.v_count, coordinate.is_rotation,
                               lock == locks.end() ? -1 : static_cast<int>(lock - locks.begin())});
      layout.q_count += coordinate.is_rotation ? 4 : 1;
      layout.v_count += coordinate.is_rotation ? 3 : 1;
    }
  }
  return layout;
}

Vector quaternion_rate(const Vector& q, const Vector& spin) {
  const Vector vector{q[1], q[2], q[3]};
  const Vector turned = cross(vector, spin);
  Vector rate{-dot(vector, spin) / 2};
  for (std::size_t i = 0; i < 3; ++i) rate.push_back((q[0] * spin[i] + turned[i]) / 2);
  return rate;
}

Motion::Motion(const System& system, const Layout& layout, const ParameterValues& parameters,
               const State& state)
    : system_(system),
      layout_(layout),
      parameters_(parameters),
      q_(state.q),
      v_(state.v),
      u_(state.u),
      now_(state.t + Jet::infinitesimal(time_infinitesimal)) {
  const Jet moment = Jet::infinitesimal(time_infinitesimal);
  set_locked();
  for (const Layout::Place& place : layout_.places) {
    if (place.lock >= 0) continue;
    if (!place.is_rotation) {
      q_[place.q] += moment * v_[place.v];
      continue;
    }
    const Vector q(q_.begin() + static_cast<long>(place.q),
                   q_.begin() + static_cast<long>(place.q) + 4);
    const Vector spin(v_.begin() + static_cast<long>(place.v),
                      v_.begin() + static_cast<long>(place.v) + 3);
    const Vector rate = quaternion_rate(q, spin);
    for (std::size_t i = 0; i < 4; ++i) q_[place.q + i] += moment * rate[i];
  }
}

/// Sets locked coordinates and their rates, which are functions of time.
void Motion::set_locked() {
  for (const Layout::Place& place : layout_.places) {
    if (place.lock < 0) continue;
    const auto& lock = system_.scene.locks[static_cast<std::size_t>(place.lock)];
    const Vector value = evaluated(lock.value, *this);
    const Vector held = place.is_rotation ? unit(value) : value;
    for (std::size_t i = 0; i < held.size(); ++i) q_[place.q + i] = held[i];
    for (std::size_t i = 0; i < (place.is_rotation ? 3U : 1U); ++i) {
      v_[place.v + i] = place.is_rotation ? Jet() : held[0].along(time_infinitesimal);
    }
  }
}

Jet Motion::value_of(const std::string& name, const std::string& element) {
  const Model& model = system_.model;
  if (const auto parameter = parameters_.find({name, element}); parameter != parameters_.end()) {
    return parameter->second;
  }
  if (has(model.definitions, name)) return evaluated(named(model.definitions, name).value, *this);
  if (has(model.prescribed, name)) return evaluated(named(model.prescribed, name).value, *this);
  if (has(model.inputs, name)) {
    return u_[static_cast<std::size_t>(&named(model.inputs, name) - model.inputs.data())];
  }
  const Coordinate& coordinate = named(model.coordinates, name);
  if (!coordinate.is_rotation) return q_[layout_.place(indexed(name, element)).q];
  // A component of a rotation has no value, only a rate: the angular velocity.
  return Jet::infinitesimal(time_infinitesimal) *
         v_[layout_.place(name).v + std::stoul(element) - 1];
}

int Motion::dimension_of(const std::string& point) {
  return static_cast<int>(named(system_.model.points, point).at.size());
}

Jet Motion::component_of(const std::string& point, const std::string& element, int axis) {
  return position_of(point, element).at(static_cast<std::size_t>(axis));
}

const Vector& Motion::position_of(const std::string& name, const std::string& element) {
  const auto known = positions_.find({name, element});
  if (known != positions_.end()) return known->second;
  const Point& point = named(system_.model.points, name);
  const auto outer = indices;
  indices.clear();
  if (point.repeat > 0) indices["i"] = std::stoi(element);
  Vector position = evaluated(point.at, *this);
  indices = outer;
  if (!point.frame.empty()) {
    const Pose& pose = pose_of(point.frame);
    position = sum(product(pose.R, position), pose.p);
  }
  return positions_[{name, element}] = position;
}

/// The rotation of a frame in its parent. Denavit-Hartenberg offsets are added to `origin`.
Matrix Motion::rotation_of(const Frame& frame, Vector& origin) {
  const Vector n = evaluated(frame.numbers, *this);
  switch (frame.turn) {
    case Turn::none:
      return identity();
    case Turn::rotate: {
      Matrix R = identity();
      for (const AxisTurn& turn : frame.turns) {
        const Jet angle = evaluated(turn.angle, *this);
        R = product(R, turn.axis.empty() ? turn_about(turn.letter, angle)
                                         : turn_about(evaluated(turn.axis, *this), angle));
      }
      return R;
    }
    case Turn::rpy:
      return product(turn_about(2, n[2]), product(turn_about(1, n[1]), turn_about(0, n[0])));
    case Turn::dh_standard:
      origin = sum(origin, {n[0] * call("cos", {n[3]}), n[0] * call("sin", {n[3]}), n[2]});
      return product(turn_about(2, n[3]), turn_about(0, n[1]));
    case Turn::dh_modified:
      origin = sum(origin, {n[0], -n[2] * call("sin", {n[1]}), n[2] * call("cos", {n[1]})});
      return product(turn_about(0, n[1]), turn_about(2, n[3]));
    case Turn::quaternion:
      return turn_by(unit(n));
    case Turn::rotation: {
      const std::size_t at = layout_.place(frame.rotation).q;
      return turn_by({q_[at], q_[at + 1], q_[at + 2], q_[at + 3]});
    }
  }
  throw std::logic_error("a turn without a case");
}

const Motion::Pose& Motion::pose_of(const std::string& name) {
  const auto known = poses_.find(name);
  if (known != poses_.end()) return known->second;
  if (name == "world") return poses_[name] = {identity(), {0, 0, 0}};
  const Frame& frame = named(system_.model.frames, name);
  const Pose parent = pose_of(frame.parent);
  Vector origin = frame.translate.empty() ? Vector{0, 0, 0} : evaluated(frame.translate, *this);
  const Matrix turn = rotation_of(frame, origin);
  return poses_[name] = {product(parent.R, turn), sum(parent.p, product(parent.R, origin))};
}

/// Angular velocity from dR/dt = [spin]x R.
Vector Motion::spin_of(const std::string& frame) {
  const Matrix& R = pose_of(frame).R;
  Matrix rate;
  Matrix still;
  for (const Vector& row : R) {
    rate.push_back(along(row, time_infinitesimal));
    still.emplace_back();
    for (const Jet& entry : row) still.back().push_back(entry.without(time_infinitesimal));
  }
  const Matrix skew = product(rate, transposed(still));
  return {skew[2][1], skew[0][2], skew[1][0]};
}

Vector Motion::turning_of(const std::string& frame, const std::string& axes) {
  const Vector spin = spin_of(frame);
  if (axes.empty()) return spin;
  Matrix still = pose_of(axes).R;
  for (Vector& row : still) {
    for (Jet& entry : row) entry = entry.without(time_infinitesimal);
  }
  return product(transposed(still), spin);
}

Jet Motion::weight(const Jet& mass, const Vector& position) {
  if (system_.model.gravity.empty()) return {};
  return -mass * dot(evaluated(system_.model.gravity, *this), position);
}

Jet Motion::body_mass_terms(const Body& body, const Vector& com, const Vector& spin_in_body) {
  const Jet m = evaluated(body.mass, *this);
  if (!body.is_about_origin) {
    const Vector velocity = along(com, time_infinitesimal);
    return m * dot(velocity, velocity) / 2;
  }
  // 1/2 m v_O^2 + m v_O . (spin x c), in the axes of the frame.
  const Pose& pose = pose_of(body.frame);
  const Vector velocity = product(transposed(pose.R), along(pose.p, time_infinitesimal));
  const Vector c = body.com.empty() ? Vector{0, 0, 0} : evaluated(body.com, *this);
  return m * dot(velocity, velocity) / 2 + m * dot(velocity, cross(spin_in_body, c));
}

Jet Motion::kinetic_energy_of(const Body& body) {
  Vector spin = evaluated(body.spin, *this);
  if (!body.frame.empty()) spin = product(transposed(pose_of(body.frame).R), spin_of(body.frame));
  Jet T;
  if (!body.inertia.empty()) {
    const Vector I = evaluated(body.inertia, *this);
    T += I.size() == 1 ? I[0] * spin[0] * spin[0] / 2 : dot(spin, product(symmetric(I), spin)) / 2;
  }
  if (!body.mass) return T;
  Vector com = body.com.empty() ? Vector{0, 0, 0} : evaluated(body.com, *this);
  if (!body.frame.empty()) {
    const Pose& pose = pose_of(body.frame);
    com = sum(product(pose.R, com), pose.p);
  }
  return T + body_mass_terms(body, com, spin);
}

void Motion::add_masses(Energies& energies) {
  for (const Body& body : system_.model.bodies) {
    energies.T += kinetic_energy_of(body);
    if (!body.mass) continue;
    Vector com = body.com.empty() ? Vector{0, 0, 0} : evaluated(body.com, *this);
    if (!body.frame.empty()) {
      const Pose& pose = pose_of(body.frame);
      com = sum(product(pose.R, com), pose.p);
    }
    energies.V += weight(evaluated(body.mass, *this), com);
  }
  for (const Point& point : system_.model.points) {
    for (int i = 1; point.mass && i <= std::max(point.repeat, 1); ++i) {
      if (point.repeat > 0) indices["i"] = i;
      const Jet mass = evaluated(point.mass, *this);
      indices.clear();
      const Vector at = position_of(point.name, point.repeat > 0 ? std::to_string(i) : "");
      const Vector velocity = along(at, time_infinitesimal);
      energies.T += mass * dot(velocity, velocity) / 2;
      energies.V += weight(mass, at);
    }
  }
}

Energies Motion::energies() {
  const Model& model = system_.model;
  Energies energies;
  const auto value = [&](const Expression& e) { return e ? evaluated(e, *this) : Jet(); };
  energies.T = value(model.T);
  energies.V = value(model.V);
  energies.D = value(model.D).without(time_infinitesimal);
  add_masses(energies);
  for (const Coordinate& coordinate : model.coordinates) {
    for (int i = 1; coordinate.armature && i <= std::max(coordinate.repeat, 1); ++i) {
      const std::string element = coordinate.repeat > 0 ? std::to_string(i) : "";
      const Jet& rate = v_[layout_.place(indexed(coordinate.name, element)).v];
      energies.T += value(coordinate.armature) * rate * rate / 2;
    }
  }
  energies.T = energies.T.without(time_infinitesimal);
  energies.V = energies.V.without(time_infinitesimal);
  energies.L = model.L ? value(model.L).without(time_infinitesimal) : energies.T - energies.V;
  return energies;
}

}  // namespace elgen::test::random
