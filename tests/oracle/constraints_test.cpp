// Constrained dynamics: values by hand, changes along motions, and the defining equations.
#include "oracle/constraints.hpp"

#include <algorithm>
#include <catch2/catch.hpp>

#include "oracle/samples.hpp"
#include "oracle/solved_dynamics.hpp"

namespace elgen::test {

using namespace elgen::oracle;
using cln::cl_R;

namespace {

using Numbers = std::vector<cl_R>;

/// A mass 2 at (x, y) on a rod of length l, with an input force along x.
ModelBuilder on_rod() {
  ModelBuilder b;
  b.coordinate("x").coordinate("y").input("u", 0).parameter("m", "2").parameter("l", "1");
  b.T("m*(x_d^2 + y_d^2)/2").V("10*m*y").constraint("x^2 + y^2 - l^2");
  return b;
}

/// A position constraint and a velocity constraint, both stabilised and dependent on time.
ModelBuilder on_moving_rod() {
  ModelBuilder b;
  b.coordinate("x").coordinate("y").coordinate("z").input("u", 0).parameter("m", "2");
  b.T("m*(x_d^2 + y_d^2 + (1 + x^2)*z_d^2)/2 + x_d*z_d*sin(y)").V("10*m*y + z^2*x").D("z_d^2");
  b.constraint("x^2 + y^2 - cos(t) - z*x").stabilised("3", "7/10");
  b.constraint("y_d - (x + t)*z_d - x*y*t", false).stabilised("5", "2");
  return b;
}

/// A blade that moves on a plane and cannot slip sideways.
ModelBuilder blade() {
  ModelBuilder b;
  b.coordinate("x").coordinate("y").coordinate("psi").T("x_d^2 + y_d^2 + psi_d^2");
  b.constraint("x_d*sin(psi) - y_d*cos(psi)", false);
  return b;
}

/// A body with central inertias 2, 3, 5, hung at the origin by its point (1/3, 0, -1/2).
ModelBuilder hung_body() {
  ModelBuilder b;
  b.coordinate("x").coordinate("y").coordinate("z").rotation("e");
  b.T("x_d^2 + y_d^2 + z_d^2 + e1_d^2 + 3/2*e2_d^2 + 5/2*e3_d^2").V("20*z");
  b.constraint("x + (e_w^2 + e_x^2 - e_y^2 - e_z^2)/3 - (e_x*e_z + e_w*e_y)");
  b.constraint("y + 2*(e_x*e_y + e_w*e_z)/3 - (e_y*e_z - e_w*e_x)");
  b.constraint("z + 2*(e_x*e_z - e_w*e_y)/3 - (e_w^2 - e_x^2 - e_y^2 + e_z^2)/2");
  return b;
}

std::vector<Model> systems_with_constraints() {
  return {on_rod().model, on_moving_rod().model, blade().model, hung_body().model};
}

State random_pose(const Model& model, unsigned seed) {
  State state = random_state(model, seed);
  set_rational_quaternions(model, state);
  return state;
}

Numbers entries(const Model& model, OutputKind kind, const State& state) {
  return value_of(model, kind, state).value();
}

cl_R product(const Numbers& matrix, std::size_t row, const Numbers& x) {
  cl_R sum = 0;
  for (std::size_t j = 0; j < x.size(); ++j) sum = sum + matrix[row * x.size() + j] * x[j];
  return sum;
}

/// The `count` entries of `values` from index `first` on.
Numbers part(const Numbers& values, std::size_t first, std::size_t count) {
  const auto begin = values.begin() + static_cast<std::ptrdiff_t>(first);
  return {begin, begin + static_cast<std::ptrdiff_t>(count)};
}

std::size_t positions_of(const Model& model) {
  return static_cast<std::size_t>(
      std::ranges::count(model.constraints, true, &Constraint::is_position));
}

/// The velocity residuals of all constraints.
Numbers rates_at(const Model& model, const State& state) {
  return part(entries(model, OutputKind::constraint_residual, state), positions_of(model),
              model.constraints.size());
}

/// Turns the quaternion of `rotation` by the small vector `by` in body axes, to second order.
void turn(State& state, const Rotation& rotation, const Numbers& by) {
  const std::size_t first = rotation.first_coordinate;
  const Numbers e = part(state.q, first, quaternion_size);
  const cl_R w = 1 - (by[0] * by[0] + by[1] * by[1] + by[2] * by[2]) / 8;
  state.q[first] = e[0] * w - (e[1] * by[0] + e[2] * by[1] + e[3] * by[2]) / 2;
  for (std::size_t k = 0; k < axis_count; ++k) {
    const std::size_t i = (k + 1) % axis_count;
    const std::size_t j = (k + 2) % axis_count;
    state.q[first + 1 + k] =
        e[1 + k] * w + (e[0] * by[k] + e[1 + i] * by[j] - e[1 + j] * by[i]) / 2;
  }
}

/// The state a time h later under the acceleration state.a, correct to second order.
State later(const Model& model, const State& state, const cl_R& h) {
  State next = state;
  next.t = state.t + h;
  Numbers way;
  for (std::size_t i = 0; i < state.v.size(); ++i) {
    way.push_back(h * state.v[i] + h * h / 2 * state.a[i]);
    next.v[i] = state.v[i] + h * state.a[i];
  }
  for (std::size_t i = 0; i < state.q.size(); ++i) {
    const Coordinate& coordinate = model.coordinates[i];
    if (!coordinate.rotation) next.q[i] = state.q[i] + way[coordinate.velocity];
  }
  for (const Rotation& rotation : model.rotations) {
    turn(next, rotation, part(way, rotation.first_velocity, axis_count));
  }
  return next;
}

/// `state` with the acceleration of forward dynamics as `state.a`.
State with_acceleration(const Model& model, State state) {
  state.a = part(entries(model, OutputKind::forward_dynamics, state), 0, state.v.size());
  return state;
}

/// `state` with h added to entry j of q, v or u (`field` 0, 1, 2). A rotation turns by the angle h.
State displaced(const Model& model, State state, std::size_t field, std::size_t j, const cl_R& h) {
  Numbers& moved = field == 0 ? state.q : field == 1 ? state.v : state.u;
  const std::optional<std::uint32_t> rotation =
      field == 0 ? model.velocities[j].rotation : std::nullopt;
  if (!rotation) {
    const std::size_t place = field == 0 ? model.velocities[j].coordinate : j;
    moved[place] = moved[place] + h;
    return state;
  }
  Numbers by(axis_count, cl_R(0));
  by[j - model.rotations[*rotation].first_velocity] = h;
  turn(state, model.rotations[*rotation], by);
  return state;
}

cl_R largest_gap(const Model& model, const State& state) {
  cl_R largest = 0;
  for (const cl_R& f :
       part(entries(model, OutputKind::constraint_residual, state), 0, positions_of(model))) {
    largest = cln::max(largest, cln::abs(f));
  }
  return largest;
}

State projected_state(const Model& model, const State& state) {
  const Numbers values = entries(model, OutputKind::projected, state);
  State next = state;
  next.q = part(values, 0, state.q.size());
  next.v = part(values, state.q.size(), state.v.size());
  return next;
}

/// Step of the central differences.
cl_R small() { return cln::expt(cl_R(10), -15); }

}  // namespace

TEST_CASE("forward dynamics of a mass on a rod, by hand") {
  const Model model = on_rod().model;
  State state = nominal_state(model, {});
  state.q = {3, 4};
  state.v = {5, 7};
  state.u = {11};
  CHECK(entries(model, OutputKind::constraint_residual, state) == Numbers{24, 86});
  CHECK(entries(model, OutputKind::constraint_jacobian, state) == Numbers{6, 8});
  CHECK(entries(model, OutputKind::constraint_bias, state) == Numbers{148});
  // lambda = (m (g y - v^2) - u x)/(2 (x^2 + y^2)), A M^-1 A^T = 4 (x^2 + y^2)/m
  const cl_R lambda = cl_R(cln::cl_RA(2 * (40 - 74) - 33) / 50);
  CHECK(entries(model, OutputKind::forward_dynamics, state) ==
        Numbers{(11 + 6 * lambda) / 2, (8 * lambda - 20) / 2, 1, 1, 1, lambda});
}

TEST_CASE("r = df/dt, A = dr/dv, and dr/dt = A a + gamma") {
  for (const Model& model : systems_with_constraints()) {
    const State state = random_pose(model, 7);
    const State before = later(model, state, -small());
    const State after = later(model, state, small());
    const Numbers rates = rates_at(model, state);
    const Numbers jacobian = entries(model, OutputKind::constraint_jacobian, state);
    const Numbers bias = entries(model, OutputKind::constraint_bias, state);
    const Numbers f = entries(model, OutputKind::constraint_residual, before);
    const Numbers g = entries(model, OutputKind::constraint_residual, after);
    const std::size_t positions = positions_of(model);
    for (std::size_t k = 0, place = 0; k < model.constraints.size(); ++k) {
      INFO("constraint " << k + 1 << " of " << model.velocities.size() << " velocities");
      const cl_R slope = (g[positions + k] - f[positions + k]) / (2 * small());
      CHECK(agree(product(jacobian, k, state.a) + bias[k], slope, 25, 1));
      State faster = state;
      for (std::size_t i = 0; i < state.v.size(); ++i) faster.v[i] = state.v[i] + state.a[i];
      CHECK(agree(rates_at(model, faster)[k] - rates[k], product(jacobian, k, state.a), 70, 1));
      if (!model.constraints[k].is_position) continue;
      CHECK(agree((g[place] - f[place]) / (2 * small()), rates[k], 25, 1));
      ++place;
    }
  }
}

TEST_CASE("a motion satisfies the equations of motion and the stabilised constraints") {
  for (const Model& model : systems_with_constraints()) {
    const State state = with_acceleration(model, random_pose(model, 8));
    const std::size_t n = state.v.size();
    const std::size_t m = model.constraints.size();
    const Numbers all = entries(model, OutputKind::forward_dynamics, state);
    const Numbers multipliers = part(all, 2 * n + m, m);
    const Numbers jacobian = entries(model, OutputKind::constraint_jacobian, state);
    const Numbers forces = entries(model, OutputKind::inverse_dynamics, state);
    const Numbers inputs = entries(model, OutputKind::input_matrix, state);
    for (std::size_t i = 0; i < n; ++i) {
      cl_R sum = state.u.empty() ? cl_R(0) : product(inputs, i, state.u);
      for (std::size_t k = 0; k < m; ++k) sum = sum + jacobian[k * n + i] * multipliers[k];
      CHECK(agree(forces[i], sum, 70, 1));
    }
    const Numbers residual = entries(model, OutputKind::constraint_residual, state);
    const Numbers bias = entries(model, OutputKind::constraint_bias, state);
    for (std::size_t k = 0; k < m; ++k) {
      const Constraint& constraint = model.constraints[k];
      cl_R sum = product(jacobian, k, state.a) + bias[k];
      if (constraint.omega) {
        const cl_R omega = *oracle_expression_value(model, *constraint.omega, state);
        const cl_R zeta = *oracle_expression_value(model, *constraint.zeta, state);
        sum = sum + 2 * zeta * omega * residual[positions_of(model) + k];
        if (constraint.is_position) sum = sum + omega * omega * residual[k];
      }
      CHECK(agree(sum, 0, 70, 1));
    }
  }
}

TEST_CASE("derivatives of constrained forward dynamics are its slopes") {
  for (const Model& model : systems_with_constraints()) {
    const State state = random_pose(model, 9);
    const std::size_t n = state.v.size();
    const Numbers derived = entries(model, OutputKind::forward_dynamics_derivatives, state);
    REQUIRE(derived.size() == n * (2 * n + state.u.size()));
    for (std::size_t field = 0; field < 3; ++field) {
      const std::size_t columns = field == 2 ? state.u.size() : n;
      for (std::size_t j = 0; j < columns; ++j) {
        const State before = displaced(model, state, field, j, -small());
        const State after = displaced(model, state, field, j, small());
        const Numbers a = entries(model, OutputKind::forward_dynamics, before);
        const Numbers b = entries(model, OutputKind::forward_dynamics, after);
        for (std::size_t i = 0; i < n; ++i) {
          INFO("of " << n << ": entry " << i << " by " << j << " in field " << field);
          const cl_R slope = (b[i] - a[i]) / (2 * small());
          CHECK(agree(derived[field * n * n + i * columns + j], slope, 22, 1));
        }
      }
    }
  }
}

TEST_CASE("a projection reduces positions quadratically and makes their rates zero") {
  for (const Model& model : {on_rod().model, hung_body().model}) {
    State state = random_pose(model, 10);
    for (int i = 0; i < 12 && largest_gap(model, state) > small(); ++i) {
      const cl_R before = largest_gap(model, state);
      state = projected_state(model, state);
      if (before < cln::cl_RA(1) / 10) CHECK(largest_gap(model, state) <= 10 * before * before);
      for (const cl_R& rate : rates_at(model, state)) CHECK(agree(rate, 0, 70, 1));
    }
    CHECK(largest_gap(model, state) < small());
  }
}

TEST_CASE("a projection keeps quaternion lengths and unconstrained coordinates") {
  const Model body = hung_body().model;
  const State held = projected_state(body, random_pose(body, 11));
  CHECK(agree(
      held.q[3] * held.q[3] + held.q[4] * held.q[4] + held.q[5] * held.q[5] + held.q[6] * held.q[6],
      1, 70));
  const Model blades = blade().model;
  const State state = random_pose(blades, 12);
  const State moved = projected_state(blades, state);
  CHECK(moved.q == state.q);
  CHECK(agree(rates_at(blades, moved)[0], 0, 70, 1));
  // The change of v is along M^-1 A^T, which is across the blade and 0 in psi.
  CHECK(agree(moved.v[2], state.v[2], 70, 1));
}

TEST_CASE("inverse dynamics returns the inputs and multipliers of a motion, without a residual") {
  for (const Model& model : {on_rod().model, on_moving_rod().model}) {
    const State state = with_acceleration(model, random_pose(model, 13));
    const std::size_t n = state.v.size();
    const std::size_t m = model.constraints.size();
    const Numbers forward = entries(model, OutputKind::forward_dynamics, state);
    const Numbers inverse = entries(model, OutputKind::constrained_inverse_dynamics, state);
    REQUIRE(inverse.size() == 1 + m + n);
    CHECK(agree(inverse[0], state.u[0], 70, 1));
    for (std::size_t k = 0; k < m; ++k) {
      CHECK(agree(inverse[1 + k], forward[2 * n + m + k], 70, 1));
    }
    for (std::size_t i = 0; i < n; ++i) CHECK(agree(inverse[1 + m + i], 0, 70, 1));
  }
}

TEST_CASE("the residual force acts neither on constraints nor on inputs") {
  const Model model = on_moving_rod().model;
  ModelBuilder free_of_one = on_moving_rod();
  free_of_one.model.constraints.pop_back();
  for (const Model& each : {model, free_of_one.model}) {
    const State state = random_pose(each, 14);
    const std::size_t m = each.constraints.size();
    const Numbers inverse = entries(each, OutputKind::constrained_inverse_dynamics, state);
    const Numbers rest = part(inverse, 1 + m, 3);
    const Numbers x = solve_mass(each, entries(each, OutputKind::mass_matrix, state), rest).x;
    const Numbers jacobian = entries(each, OutputKind::constraint_jacobian, state);
    for (std::size_t k = 0; k < m; ++k) CHECK(agree(product(jacobian, k, x), 0, 70, 1));
    CHECK(agree(x[0], 0, 70, 1));
    // Input and two constraint forces balance every force. Input and one constraint force do not.
    const bool is_balanced = cln::abs(rest[1]) + cln::abs(rest[2]) < small();
    CHECK(is_balanced == (m == 2));
  }
}

TEST_CASE("contractions of constrained outputs are sums over all entries") {
  const Model model = on_moving_rod().model;
  const State state = random_pose(model, 15);
  for (const OutputKind kind :
       {OutputKind::constraint_residual, OutputKind::constraint_bias, OutputKind::projected,
        OutputKind::constrained_inverse_dynamics, OutputKind::forward_dynamics}) {
    const Numbers all = entries(model, kind, state);
    std::size_t first = 0;
    for (std::size_t field = 0; field < output_row(kind).fields.size(); ++field) {
      const Extent extent = output_row(kind).fields[field].rows;
      const std::size_t rows = extent == Extent::pivots        ? 5
                               : extent == Extent::constraints ? 2
                               : extent == Extent::velocities  ? 3
                               : extent == Extent::coordinates ? 3
                                                               : 1;
      Contraction by{.field = field};
      cl_R sum = 0;
      for (std::size_t i = 0; i < rows; ++i) {
        by.w.emplace_back(static_cast<long>(2 * i + 1));
        sum = sum + by.w.back() * all[first + i];
      }
      first += rows;
      INFO(output_row(kind).name << " field " << field);
      CHECK(agree(oracle_contraction(model, {.kind = kind}, state, by).value(), sum, 70, 1));
    }
    CHECK(first == all.size());
  }
}

}  // namespace elgen::test
