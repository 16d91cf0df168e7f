// Results of the equations: accelerations, derivatives, reactions, kinematics, user outputs.
#include "random/truth.hpp"

namespace elgen::test::random {

namespace {

Vector difference(Vector a, const Vector& b) {
  for (std::size_t i = 0; i < a.size(); ++i) a[i] -= b[i];
  return a;
}

Matrix negative(Matrix rows) {
  for (Vector& row : rows) row = difference(Vector(row.size()), row);
  return rows;
}

Matrix column(const Vector& x) { return transposed({x}); }

}  // namespace

/// Adds B and the acceleration M^-1 (B u - bias).
void Truth::add_solutions(const Matrix& M) {
  const std::vector<std::size_t> acting = acting_inputs(system_);
  Matrix columns;
  for (const std::size_t k : acting) {
    State moved = state_;
    moved.u[k] += Jet::infinitesimal(second);
    columns.push_back(along(free_entries(forces(layout_, moved)), second));
  }
  if (!columns.empty()) keep("input_matrix", transposed(columns));
  State coasting = state_;
  for (Jet& a : coasting.a) a = 0;
  Vector right = free_entries(torque(layout_, coasting));
  for (std::size_t i = 0; i < right.size(); ++i) {
    right[i] = -right[i];
    for (std::size_t k = 0; k < columns.size(); ++k) {
      right[i] += columns[k][i] * state_.u[acting[k]];
    }
  }
  keep("forward_dynamics.acceleration", transposed(solved(M, column(right)))[0]);
}

/// d(M a + bias - B u)/dx, x = v if `by_velocity`, otherwise x = q. B u counts if `has_inputs`.
Matrix Truth::torque_slopes(const State& at, bool has_inputs, bool by_velocity) const {
  Matrix columns;
  for (const std::size_t k : free_) {
    State moved = by_velocity ? at : displaced(layout_, at, k, second);
    if (by_velocity) moved.v[k] += Jet::infinitesimal(second);
    Vector slope = along(free_entries(torque(layout_, moved)), second);
    if (has_inputs) {
      State without = moved;
      for (Jet& u : without.u) u = 0;
      const Vector inputs =
          difference(free_entries(forces(layout_, moved)), free_entries(forces(layout_, without)));
      slope = difference(slope, along(inputs, second));
    }
    columns.push_back(slope);
  }
  return transposed(columns);
}

/// da/dx = -M^-1 d(M a + bias - B u)/dx at the acceleration of forward dynamics.
void Truth::add_derivatives(const Matrix& M) {
  const std::size_t n = free_.size();
  State driven = state_;
  for (std::size_t i = 0; i < n; ++i) {
    driven.a[free_[i]] = values_["forward_dynamics.acceleration"][i];
  }
  keep("inverse_dynamics_derivatives.by_position", torque_slopes(state_, false, false));
  keep("inverse_dynamics_derivatives.by_velocity", torque_slopes(state_, false, true));
  const Matrix by_position = negative(solved(M, torque_slopes(driven, true, false)));
  const Matrix by_velocity = negative(solved(M, torque_slopes(driven, true, true)));
  keep("forward_dynamics_derivatives.by_position", by_position);
  keep("forward_dynamics_derivatives.by_velocity", by_velocity);
  // For x = (q, v) the deviation of a rotation has the rate dv - [w]x dq.
  const Matrix spinning = negative(turning(free_entries(state_.v)));
  Matrix A(2 * n, Vector(2 * n));
  for (std::size_t i = 0; i < n; ++i) {
    A[i][n + i] = 1;
    for (std::size_t j = 0; j < n; ++j) {
      A[i][j] = spinning[i][j];
      A[n + i][j] = by_position[i][j];
      A[n + i][n + j] = by_velocity[i][j];
    }
  }
  keep("linearization.A", A);
  const std::size_t inputs = acting_inputs(system_).size();
  if (inputs == 0) return;
  Matrix B;
  const auto& entries = values_["input_matrix"];
  for (std::size_t i = 0; i < n; ++i) {
    const auto start = entries.begin() + static_cast<long>(i * inputs);
    B.emplace_back(start, start + static_cast<long>(inputs));
  }
  const Matrix by_input = solved(M, B);
  keep("forward_dynamics_derivatives.by_input", by_input);
  keep("linearization.B", Matrix(n, Vector(inputs)));
  keep("linearization.B", by_input);
}

/// Adds the reactions: rows M a + bias - B u of the locked coordinates, which move by their laws.
void Truth::add_reaction() {
  State held = state_;
  State moved = state_;
  moved.t += Jet::infinitesimal(moment);
  Motion motion(system_, layout_, parameters_, moved);
  for (const Layout::Place& place : layout_.places) {
    if (place.lock < 0) continue;
    const Lock& lock = system_.scene.locks[static_cast<std::size_t>(place.lock)];
    Vector value = evaluated(lock.value, motion);
    const Jet length = place.is_rotation ? power(dot(value, value), 1, 2) : Jet(1);
    for (std::size_t i = 0; i < value.size(); ++i) {
      const Jet entry = value[i] / length;
      held.q[place.q + i] = entry.value();
      if (place.is_rotation) continue;
      held.v[place.v] = entry.along(time_infinitesimal).value();
      held.a[place.v] = entry.along(time_infinitesimal).along(moment).value();
    }
    if (place.is_rotation) {
      for (std::size_t i = 0; i < 3; ++i) held.v[place.v + i] = held.a[place.v + i] = 0;
    }
  }
  Vector rows;
  State without = held;
  for (Jet& u : without.u) u = 0;
  for (const Layout::Place& place : layout_.places) {
    if (place.lock < 0) continue;
    if (!system_.scene.locks[static_cast<std::size_t>(place.lock)].has_reaction) continue;
    const Vector torques = torque(whole_, held);
    const Vector inputs = difference(forces(whole_, held), forces(whole_, without));
    for (std::size_t i = 0; i < (place.is_rotation ? 3U : 1U); ++i) {
      rows.push_back(torques[place.v + i] - inputs[place.v + i]);
    }
  }
  if (!rows.empty()) keep("reaction", rows);
}

void Truth::add_kinematics() {
  bool turns = false;
  Vector rates;
  Vector normalized;
  const State moved = later(layout_, state_, moment);
  for (const Layout::Place& place : layout_.places) {
    if (place.lock >= 0) continue;
    turns = turns || place.is_rotation;
    for (std::size_t i = 0; i < (place.is_rotation ? 4U : 1U); ++i) {
      rates.push_back(moved.q[place.q + i].along(moment));
      normalized.push_back(state_.q[place.q + i]);
    }
  }
  if (!turns) return;
  keep("coordinate_rates", rates);
  keep("normalized", normalized);
}

/// The values of an [[output]], or the pose of its frame row by row.
Vector Truth::output_values(const Output& output, const State& state) const {
  Motion motion(system_, layout_, parameters_, state);
  Vector values;
  if (output.frame.empty()) {
    for (const Jet& value : evaluated(output.value, motion)) {
      values.push_back(value.without(time_infinitesimal));
    }
    return values;
  }
  const Motion::Pose& pose = motion.pose_of(output.frame);
  for (std::size_t i = 0; i < 3; ++i) {
    for (const Jet& entry : pose.R[i]) values.push_back(entry.without(time_infinitesimal));
    values.push_back(pose.p[i].without(time_infinitesimal));
  }
  return values;
}

/// The rates of the values, or the twist: angular velocity, then velocity of the origin.
Vector Truth::output_rates(const Output& output, const State& state) const {
  Motion motion(system_, layout_, parameters_, state);
  if (output.frame.empty()) return along(evaluated(output.value, motion), time_infinitesimal);
  const Motion::Pose& pose = motion.pose_of(output.frame);
  Matrix R = transposed(pose.R);
  for (Vector& row : R) {
    for (Jet& entry : row) entry = entry.without(time_infinitesimal);
  }
  Vector spin = motion.spin_of(output.frame);
  Vector velocity = along(pose.p, time_infinitesimal);
  if (output.in_frame_axes) {
    spin = product(R, spin);
    velocity = product(R, velocity);
  }
  spin.insert(spin.end(), velocity.begin(), velocity.end());
  return spin;
}

void Truth::add_output(const Output& output) {
  keep(output.name, output_values(output, state_));
  if (!output.has_jacobian) return;
  Matrix columns;
  for (const std::size_t j : free_) {
    State moved = state_;
    moved.v[j] += Jet::infinitesimal(direction);
    columns.push_back(along(output_rates(output, moved), direction));
  }
  keep(output.name + "_jacobian", transposed(columns));
  State coasting = state_;
  for (Jet& a : coasting.a) a = 0;
  keep(output.name + "_bias",
       along(output_rates(output, later(layout_, coasting, moment)), moment));
}

}  // namespace elgen::test::random
