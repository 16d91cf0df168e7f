// Models with constraints have the accelerations and energies of equivalent models in minimal
// coordinates. Names and numbers differ from the models in models/.
#include <algorithm>
#include <catch2/catch.hpp>

#include "pipeline/constrained_testing.hpp"
#include "support/matrices.hpp"

namespace elgen::test {
namespace {

using cln::cl_R;

const std::string hanging = R"toml(
m = { value = 0.37, assume = "positive" }
L = { value = 1.3, assume = "positive" }
g = { value = 9.78, assume = "positive" }
[gravity]
vector = ["0", "-g"]
)toml";

const std::string pendulum_on_rod = R"toml(format = 1
[model]
name = "on_rod"
[[coordinate]]
name = "right"
start = { value = 0 }
[[coordinate]]
name = "up"
start = { value = -1.3 }
[[point]]
name = "weight"
at = ["right", "up"]
mass = "m"
[[constraint]]
name = "wire"
equation = "hypot(right, up) = L"
[parameters]
)toml" + hanging;

const std::string pendulum_by_angle = R"toml(format = 1
[model]
name = "by_angle"
[[coordinate]]
name = "swing"
[[point]]
name = "weight"
at = ["L*sin(swing)", "-L*cos(swing)"]
mass = "m"
[[output]]
name = "twin"
value = ["x(weight)", "y(weight)"]
jacobian = true
[parameters]
)toml" + hanging;

/// A crank, a coupler and a rocker of point masses and rods, without the text of the coordinates.
const std::string linkage = R"toml(
[parameters]
r1 = { value = 0.3, assume = "positive" }
r2 = { value = 0.9, assume = "positive" }
r3 = { value = 0.7, assume = "positive" }
base = { value = 0.8, assume = "positive" }
m1 = { value = 0.4, assume = "positive" }
m2 = { value = 0.7, assume = "positive" }
m3 = { value = 1.1, assume = "positive" }
g = 9.78
[[body]]
name = "crank"
mass = "m1"
com = ["r1/3*cos(alpha)", "r1/3*sin(alpha)"]
spin = "dot(alpha)"
inertia = "m1*r1^2/9"
[[body]]
name = "coupler"
mass = "m2"
com = ["r1*cos(alpha) + r2/2*cos(beta)", "r1*sin(alpha) + r2/2*sin(beta)"]
spin = "dot(beta)"
inertia = "m2*r2^2/12"
[[body]]
name = "rocker"
mass = "m3"
com = ["base + 2*r3/3*cos(gamma)", "2*r3/3*sin(gamma)"]
spin = "dot(gamma)"
inertia = "m3*r3^2/9"
[gravity]
vector = ["0", "-g"]
[[input]]
name = "motor"
on = "alpha"
)toml";

const std::string linkage_of_three_angles = R"toml(format = 1
[model]
name = "three_angles"
[[coordinate]]
name = "alpha"
start = { value = 0.8 }
[[coordinate]]
name = "beta"
start = { value = 0.54 }
[[coordinate]]
name = "gamma"
start = { value = 1.31 }
[[constraint]]
name = "closing"
equation = [
  "r1*cos(alpha) + r2*cos(beta) = base + r3*cos(gamma)",
  "r1*sin(alpha) + r2*sin(beta) = r3*sin(gamma)",
]
)toml" + linkage;

const std::string linkage_of_one_angle = R"toml(format = 1
[model]
name = "one_angle"
[[coordinate]]
name = "alpha"
[define]
reach = "hypot(base - r1*cos(alpha), r1*sin(alpha))"
beta = "acos((r2^2 + reach^2 - r3^2)/(2*r2*reach)) - atan2(r1*sin(alpha), base - r1*cos(alpha))"
gamma = "atan2(r1*sin(alpha) + r2*sin(beta), r1*cos(alpha) + r2*cos(beta) - base)"
[[output]]
name = "twin"
value = ["alpha", "beta", "gamma"]
jacobian = true
)toml" + linkage;

const std::string wheels = R"toml(
[parameters]
mass = { value = 3.7, assume = "positive" }
radius = { value = 0.45, assume = "positive" }
axle = { value = 0.31, assume = "positive" }
vertical = { value = 0.17, assume = "positive" }
[[input]]
name = "pedal"
on = "rolled"
[[input]]
name = "handlebar"
on = "heading"
[energy]
)toml";

const std::string wheel_on_plane = R"toml(format = 1
[model]
name = "on_plane"
[[coordinate]]
name = "heading"
[[coordinate]]
name = "east"
[[coordinate]]
name = "rolled"
[[coordinate]]
name = "north"
[[constraint]]
name = "no_slip_north"
kind = "velocity"
equation = "dot(north) - radius*sin(heading)*dot(rolled) = 0"
[[constraint]]
name = "no_slip_east"
kind = "velocity"
equation = "radius*cos(heading)*dot(rolled) = dot(east)"
)toml" + wheels + R"toml(
T = """1/2*mass*(dot(east)^2 + dot(north)^2) + 1/2*axle*dot(rolled)^2
  + 1/2*vertical*dot(heading)^2"""
)toml";

/// The wheel in two angles: the force across the wheel does no work and has no vertical moment.
const std::string wheel_of_two_angles = R"toml(format = 1
[model]
name = "two_angles"
[[coordinate]]
name = "heading"
[[coordinate]]
name = "rolled"
)toml" + wheels + R"toml(
T = "1/2*(axle + mass*radius^2)*dot(rolled)^2 + 1/2*vertical*dot(heading)^2"
)toml";

/// A top: a body with six velocities, and a constraint that holds a point of its axis.
const std::string hung_top = R"toml(format = 1
[model]
name = "hung_top"
[[coordinate]]
name = "x"
[[coordinate]]
name = "y"
[[coordinate]]
name = "z"
start = { value = 0.15 }
[[coordinate]]
name = "e"
kind = "rotation"
[parameters]
m = { value = 1, assume = "positive" }
h = { value = 0.15, assume = "positive" }
A = { value = 0.05, assume = "positive" }
C = { value = 0.02, assume = "positive" }
g = 9.81
[[frame]]
name = "top"
parent = "world"
translate = ["x", "y", "z"]
rotation = "e"
[[body]]
name = "spinning"
frame = "top"
mass = "m"
inertia = ["A - m*h^2", "A - m*h^2", "C"]
[[point]]
name = "tip"
frame = "top"
at = ["0", "0", "-h"]
[[point]]
name = "pivot"
at = ["0", "0", "0"]
[gravity]
vector = ["0", "0", "-g"]
[[constraint]]
name = "joint"
coincide = ["tip", "pivot"]
)toml";

ExactNumbers minimal_output(const Constrained& free, OutputKind kind, const State& state) {
  return free.truth(kind, "", state);
}

/// The state and acceleration of the constrained model `bound` at `state` of the minimal model
/// `free`. The output `twin` of `free` gives the coordinates of `bound`.
State constrained_state(const Constrained& bound, const Constrained& free, const State& state) {
  State result = bound.nominal();
  result.u = state.u;
  const ExactNumbers jacobian = minimal_output(free, OutputKind::user_jacobian, state);
  result.q = minimal_output(free, OutputKind::user_value, state);
  result.v = product(jacobian, state.v, state.v.size());
  result.a = product(jacobian, free.truth(OutputKind::forward_dynamics, "acceleration", state),
                     state.v.size());
  const ExactNumbers bias = minimal_output(free, OutputKind::user_bias, state);
  for (std::size_t i = 0; i < bias.size(); ++i) result.a[i] = result.a[i] + bias[i];
  return result;
}

void check_equivalent(const std::string& bound_text, const std::string& free_text,
                      const std::vector<State>& states) {
  const Constrained bound(bound_text, "forward_dynamics");
  const Constrained free(free_text, "forward_dynamics,twin,twin_jacobian,twin_bias");
  for (const State& each : states) {
    State state = free.nominal();
    state.q = each.q;
    state.v = each.v;
    if (!state.u.empty()) state.u = each.u;
    const State at = constrained_state(bound, free, state);
    check_field(bound, OutputKind::forward_dynamics, "acceleration", at, at.a);
  }
}

State motion(const ExactNumbers& q, const ExactNumbers& v, const ExactNumbers& u) {
  State state;
  state.q = q;
  state.v = v;
  state.u = u;
  return state;
}

cl_R value_at(const Constrained& system, ExpressionId expression, const State& state) {
  return oracle_expression_value(system.model(), expression, state).value();
}

cl_R rate_at(const Constrained& system, ExpressionId expression, const State& state) {
  return oracle_expression_rate(system.model(), expression, state).value();
}

/// The quaternion of the Euler angles phi, theta, psi about the axes z, x, z.
ExactNumbers quaternion_of(const ExactNumbers& angles) {
  const Real half = Real(exact("1/2"));
  const Real sum = half * Real(angles[0] + angles[2]);
  const Real difference = half * Real(angles[0] - angles[2]);
  const Real theta = half * Real(angles[1]);
  return {(cos(theta) * cos(sum)).value(), (sin(theta) * cos(difference)).value(),
          (sin(theta) * sin(difference)).value(), (cos(theta) * sin(sum)).value()};
}

}  // namespace

TEST_CASE("a mass on a rod has the accelerations of a pendulum with an angle") {
  check_equivalent(pendulum_on_rod, pendulum_by_angle,
                   {motion({exact("0.7")}, {exact("-1.9")}, {}), motion({exact("2.8")}, {4}, {}),
                    motion({0}, {1}, {})});
}

TEST_CASE(
    "a four-bar linkage with three angles moves like the linkage with the crank's angle only") {
  check_equivalent(linkage_of_three_angles, linkage_of_one_angle,
                   {motion({exact("0.8")}, {exact("2.5")}, {exact("0.6")}),
                    motion({exact("-1.1")}, {exact("-3.5")}, {exact("-1.5")}),
                    motion({exact("2.9")}, {0}, {0})});
}

TEST_CASE("a wheel rolls like the model with two angles") {
  const Constrained bound(wheel_on_plane, "forward_dynamics");
  const Constrained free(wheel_of_two_angles, "forward_dynamics");
  State state = free.nominal();
  state.q = {exact("0.7"), exact("-5.3")};
  state.v = {exact("1.9"), exact("-2.3")};
  state.u = {exact("0.8"), exact("-0.6")};
  const ExactNumbers a = free.truth(OutputKind::forward_dynamics, "acceleration", state);
  State at = bound.nominal();
  const Real radius(exact("0.45"));
  const cl_R east = (radius * cos(Real(state.q[0]))).value();
  const cl_R north = (radius * sin(Real(state.q[0]))).value();
  const cl_R turning = state.v[0] * state.v[1];
  at.q = {state.q[0], 3, state.q[1], -2};
  at.v = {state.v[0], east * state.v[1], state.v[1], north * state.v[1]};
  at.u = state.u;
  check_field(bound, OutputKind::forward_dynamics, "acceleration", at,
              {a[0], east * a[1] - north * turning, a[1], north * a[1] + east * turning});
}

TEST_CASE("a free body fixed at a point moves like the heavy top") {
  const Constrained bound(hung_top, "forward_dynamics,total_energy,constraint_residual");
  const Constrained top(model_file("heavy_top"), "forward_dynamics,total_energy");
  State state = top.nominal();
  state.parameters[1] = exact("0.15");  // h, as in the other model
  state.q = {exact("0.4"), exact("0.9"), exact("-1.7")};
  state.v = {exact("1.3"), exact("-0.8"), exact("11.5")};
  state.a = top.truth(OutputKind::forward_dynamics, "acceleration", state);
  const std::vector<ExpressionId>& spin = top.model().bodies[0].spin;
  State at = bound.nominal();
  ExactNumbers turning;
  for (std::size_t i = 0; i < 3; ++i) {
    const ExpressionId centre = top.model().points[0].position[i];
    at.q[i] = value_at(top, centre, state);
    at.v[i] = rate_at(top, centre, state);
    at.v[3 + i] = value_at(top, spin[i], state);
    turning.push_back(rate_at(top, spin[i], state));
  }
  const ExactNumbers quaternion = quaternion_of(state.q);
  std::copy(quaternion.begin(), quaternion.end(), at.q.begin() + 3);
  for (const char* field : {"position", "rate"}) {
    for (const cl_R& off : bound.truth(OutputKind::constraint_residual, field, at)) {
      CHECK(cln::abs(off) <= power_of_ten(-50));
    }
  }
  const ExactNumbers all = bound.truth(OutputKind::forward_dynamics, "acceleration", at);
  check_digits({all.begin() + 3, all.end()}, turning, 40);
  check_field(bound, OutputKind::forward_dynamics, "acceleration", at, all);
  const ExactNumbers energy = top.truth(OutputKind::total_energy, "", state);
  check_field(bound, OutputKind::total_energy, "", at, energy);
}

}  // namespace elgen::test
