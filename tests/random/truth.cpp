// Lagrange's equations from jets of L, and the outputs that they define.
#include "random/truth.hpp"

#include <algorithm>
#include <stdexcept>
#include <utility>

namespace elgen::test::random {

namespace {

constexpr unsigned third = 4;

Vector spin_at(const Vector& v, const Layout::Place& place) {
  return {v[place.v], v[place.v + 1], v[place.v + 2]};
}

}  // namespace

State later(const Layout& layout, const State& state, unsigned index) {
  const Jet e = Jet::infinitesimal(index);
  State result = state;
  result.t += e;
  for (const Layout::Place& place : layout.places) {
    if (!place.is_rotation) {
      result.q[place.q] += e * state.v[place.v];
      result.v[place.v] += e * state.a[place.v];
      continue;
    }
    const Vector q{state.q[place.q], state.q[place.q + 1], state.q[place.q + 2],
                   state.q[place.q + 3]};
    const Vector rate = quaternion_rate(q, spin_at(state.v, place));
    for (std::size_t i = 0; i < 4; ++i) result.q[place.q + i] += e * rate[i];
    for (std::size_t i = 0; i < 3; ++i) result.v[place.v + i] += e * state.a[place.v + i];
  }
  return result;
}

State displaced(const Layout& layout, const State& state, std::size_t index, unsigned along) {
  State still = state;
  for (Jet& v : still.v) v = 0;
  for (Jet& a : still.a) a = 0;
  still.v[index] = 1;
  State result = later(layout, still, along);
  result.v = state.v;
  result.a = state.a;
  result.t = state.t;
  return result;
}

Matrix solved(Matrix M, Matrix columns) {
  const std::size_t n = M.size();
  for (std::size_t k = 0; k < n; ++k) {
    std::size_t pivot = k;
    for (std::size_t i = k; i < n; ++i) {
      if (abs(M[i][k].value()) > abs(M[pivot][k].value())) pivot = i;
    }
    std::swap(M[k], M[pivot]);
    std::swap(columns[k], columns[pivot]);
    // With 80 digits and moderate numbers, a pivot below 1e-60 is a zero of M.
    if (abs(M[k][k].value()) < Number("1e-60")) throw std::domain_error("singular");
    for (std::size_t i = 0; i < n; ++i) {
      if (i == k) continue;
      const Jet factor = M[i][k] / M[k][k];
      for (std::size_t j = 0; j < n; ++j) M[i][j] -= factor * M[k][j];
      for (std::size_t j = 0; j < columns[i].size(); ++j) columns[i][j] -= factor * columns[k][j];
    }
  }
  for (std::size_t k = 0; k < n; ++k) {
    for (Jet& entry : columns[k]) entry = entry / M[k][k];
  }
  return columns;
}

ParameterValues given_parameters(const System& system) {
  System constants;
  const Layout layout;
  ParameterValues none;
  Motion scope(constants, layout, none, {});
  const auto number = [&](const Expression& e) { return evaluated(e, scope).value(); };
  ParameterValues values;
  for (const Parameter& parameter : system.model.parameters) {
    for (std::size_t i = 0; i < parameter.values.size(); ++i) {
      const std::string element = parameter.is_array ? std::to_string(i + 1) : "";
      values[{parameter.name, element}] = number(parameter.values[i]);
    }
  }
  for (const Named& fixed : system.scene.fixed) values[{fixed.name, ""}] = number(fixed.value);
  return values;
}

Truth::Truth(const System& system, ParameterValues parameters, State state)
    : system_(system),
      parameters_(std::move(parameters)),
      layout_(layout_of(system.model, system.scene.locks)),
      whole_(layout_of(system.model, {})),
      state_(std::move(state)) {
  for (const Layout::Place& place : layout_.places) {
    if (place.lock >= 0) continue;
    for (std::size_t i = 0; i < (place.is_rotation ? 3U : 1U); ++i) free_.push_back(place.v + i);
  }
}

/// `state` with the deviations and rates of expanded coordinates multiplied by s. If all
/// coordinates are expanded, u is multiplied by s too.
State Truth::small(const Layout& layout, State state) const {
  const Jet scale = Jet::scale();
  const bool all = system_.scene.about.size() == layout.places.size();
  for (const Named& about : system_.scene.about) {
    const Layout::Place& place = layout.place(about.name);
    System constants;
    const Layout nothing;
    Motion scope(constants, nothing, parameters_, {});
    const Jet start = evaluated(about.value, scope).value();
    state.q[place.q] = start + scale * (state.q[place.q] - start);
    state.v[place.v] = scale * state.v[place.v];
  }
  for (Jet& u : state.u) u = all ? scale * u : u;
  return state;
}

/// The result of `read`, truncated after s^(order + 1) if the scene has an order > 0.
Jet Truth::read(const Layout& layout, const State& state, const Read& read) const {
  const int order = system_.scene.order;
  if (order == 0) {
    Motion motion(system_, layout, parameters_, state);
    return read(motion);
  }
  Jet::order = order + 1;
  Motion motion(system_, layout, parameters_, small(layout, state));
  const Jet result = read(motion).up_to(order + 1);
  Jet::order = 0;
  return result;
}

Jet Truth::lagrangian(const Layout& layout, const State& state) const {
  return read(layout, state, [](Motion& motion) { return motion.energies().L; });
}

Vector Truth::momentum(const Layout& layout, const State& state) const {
  Vector p;
  for (std::size_t j = 0; j < layout.v_count; ++j) {
    State moved = state;
    moved.v[j] += Jet::infinitesimal(direction);
    p.push_back(lagrangian(layout, moved).along(direction));
  }
  return p;
}

/// d/dt dL/dv - dL/dq.
Vector Truth::inertial(const Layout& layout, const State& state) const {
  const Vector p = momentum(layout, later(layout, state, moment));
  Vector result;
  for (std::size_t j = 0; j < layout.v_count; ++j) {
    const State moved = displaced(layout, state, j, direction);
    result.push_back(p[j].along(moment) - lagrangian(layout, moved).along(direction));
  }
  for (const Layout::Place& place : layout.places) {
    if (!place.is_rotation) continue;
    Vector spin_momentum = spin_at(p, place);
    for (Jet& entry : spin_momentum) entry = entry.without(moment);
    const Vector turning = cross(spin_at(state.v, place), spin_momentum);
    for (std::size_t i = 0; i < 3; ++i) result[place.v + i] += turning[i];
  }
  return result;
}

Vector Truth::dissipation(const Layout& layout, const State& state) const {
  Vector result;
  for (std::size_t j = 0; j < layout.v_count; ++j) {
    State moved = state;
    moved.v[j] += Jet::infinitesimal(direction);
    result.push_back(
        read(layout, moved, [](Motion& motion) { return motion.energies().D; }).along(direction));
  }
  return result;
}

/// B u + Q.
Vector Truth::forces(const Layout& layout, const State& state) const {
  Vector result;
  for (std::size_t j = 0; j < layout.v_count; ++j) {
    State moved = state;
    moved.v[j] += Jet::infinitesimal(direction);
    result.push_back(
        read(layout, moved, [](Motion& motion) { return motion.force_along(direction); }));
  }
  return result;
}

/// M a + bias, with all inputs 0.
Vector Truth::torque(const Layout& layout, const State& state) const {
  State alone = state;
  for (Jet& u : alone.u) u = 0;
  Vector result = inertial(layout, alone);
  const Vector lost = dissipation(layout, alone);
  const Vector applied = forces(layout, alone);
  for (std::size_t j = 0; j < result.size(); ++j) result[j] += lost[j] - applied[j];
  return result;
}

Matrix Truth::mass_matrix(const State& state) const {
  Matrix M;
  for (const std::size_t i : free_) {
    M.emplace_back();
    for (const std::size_t j : free_) {
      if (M.size() > M.back().size() + 1) {
        M.back().push_back(M[M.back().size()][M.size() - 1]);
        continue;
      }
      State moved = state;
      moved.v[i] += Jet::infinitesimal(direction);
      moved.v[j] += Jet::infinitesimal(second);
      M.back().push_back(lagrangian(layout_, moved).along(direction).along(second));
    }
  }
  return M;
}

State Truth::state_at_rest(State state) const {
  for (Jet& v : state.v) v = 0;
  for (Jet& a : state.a) a = 0;
  return state;
}

void Truth::keep(const std::string& name, const Vector& entries) {
  auto& values = values_[name];
  for (const Jet& entry : entries) values.push_back(entry.value());
}

void Truth::keep(const std::string& name, const Matrix& rows) {
  for (const Vector& row : rows) keep(name, row);
}

Vector Truth::free_entries(const Vector& all) const {
  Vector result;
  for (const std::size_t i : free_) result.push_back(all[i]);
  return result;
}

/// Block diagonal: [x_i]x for each free rotation i, 0 elsewhere; x_i are three entries of `x`.
Matrix Truth::turning(const Vector& x) const {
  const std::size_t n = free_.size();
  Matrix result(n, Vector(n));
  for (const Layout::Place& place : layout_.places) {
    const auto at = std::find(free_.begin(), free_.end(), place.v);
    if (!place.is_rotation || at == free_.end()) continue;
    const auto i = static_cast<std::size_t>(at - free_.begin());
    for (std::size_t k = 0; k < 3; ++k) {
      result[i + (k + 1) % 3][i + (k + 2) % 3] = -x[i + k];
      result[i + (k + 2) % 3][i + (k + 1) % 3] = x[i + k];
    }
  }
  return result;
}

/// For h = C v = (dM/dq v) v + [w]x M v - 1/2 d(v M v)/dq: C = 1/2 dh/dv + 1/2 M [w]x, from the
/// Christoffel symbols of M. With y = M v held constant, d([w]x y)/dw = -[y]x.
Matrix Truth::coriolis_matrix(const Matrix& M) const {
  const std::size_t n = free_.size();
  std::vector<Matrix> slopes;  // of M, along every velocity
  for (const std::size_t k : free_) {
    slopes.push_back(mass_matrix(displaced(layout_, state_, k, third)));
    for (Vector& row : slopes.back()) {
      for (Jet& entry : row) entry = entry.along(third);
    }
  }
  const Vector v = free_entries(state_.v);
  const Matrix turned = product(turning(v), M);
  const Matrix by_spin = product(M, turning(v));
  const Matrix by_momentum = turning(product(M, v));
  Matrix C(n, Vector(n));
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = 0; j < n; ++j) {
      C[i][j] = (turned[i][j] + by_spin[i][j] - by_momentum[i][j]) / 2;
      for (std::size_t k = 0; k < n; ++k) {
        C[i][j] += (slopes[k][i][j] + slopes[j][i][k] - slopes[i][j][k]) * v[k] / 2;
      }
    }
  }
  return C;
}

/// Adds C, C v, g, and the drift d/dt dL/dv - dL/dq - C v - g at a = 0.
void Truth::add_velocity_terms(const Matrix& M) {
  const Matrix C = coriolis_matrix(M);
  const Vector h = product(C, free_entries(state_.v));
  State coasting = state_;
  for (Jet& a : coasting.a) a = 0;
  Vector drift = free_entries(inertial(layout_, coasting));
  Vector g;
  for (const std::size_t j : free_) {
    const State moved = displaced(layout_, state_at_rest(state_), j, direction);
    g.push_back(
        read(layout_, moved, [](Motion& motion) { return motion.energies().V; }).along(direction));
  }
  for (std::size_t i = 0; i < h.size(); ++i) drift[i] -= h[i] + g[i];
  keep("coriolis_matrix", C);
  keep("velocity_force", h);
  keep("gravity", g);
  keep("drift", drift);
}

void Truth::add_energies() {
  const auto energy = [&](const State& state, Jet Energies::*part) {
    return read(layout_, state, [&](Motion& motion) { return motion.energies().*part; });
  };
  const Vector p = free_entries(momentum(layout_, state_));
  const Vector v = free_entries(state_.v);
  keep("momentum", p);
  Vector gradient;
  for (const std::size_t j : free_) {
    gradient.push_back(
        lagrangian(layout_, displaced(layout_, state_, j, direction)).along(direction));
  }
  keep("position_gradient", gradient);
  keep("energy_function", Vector{dot(p, v) - lagrangian(layout_, state_)});
  if (system_.model.L) return;
  const Jet T = energy(state_, &Energies::T);
  keep("kinetic_energy", Vector{T});
  keep("total_energy", Vector{T + energy(state_, &Energies::V)});
  keep("potential_energy", Vector{energy(state_at_rest(state_), &Energies::V)});
}

void Truth::add_forces() {
  State coasting = state_;
  for (Jet& a : coasting.a) a = 0;
  keep("bias", free_entries(torque(layout_, coasting)));
  keep("inverse_dynamics", free_entries(torque(layout_, state_)));
  keep("dissipation", free_entries(dissipation(layout_, state_)));
  State alone = state_;
  for (Jet& u : alone.u) u = 0;
  keep("applied_force", free_entries(forces(layout_, alone)));
}

Values Truth::outputs() {
  values_.clear();
  const Matrix M = mass_matrix(state_);
  keep("mass_matrix", M);
  if (!system_.model.L) add_velocity_terms(M);
  add_energies();
  add_forces();
  add_reaction();
  try {
    add_solutions(M);
    add_derivatives(M);
  } catch (const std::domain_error&) {
    // M is singular, so the definition gives no acceleration.
  }
  add_kinematics();
  for (const Output& output : system_.model.outputs) add_output(output);
  return values_;
}

}  // namespace elgen::test::random
