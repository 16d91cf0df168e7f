// Outputs of scenes: reaction forces of locked coordinates, and Taylor polynomials of every output.
#include <catch2/catch.hpp>

#include "elgen/oracle.hpp"
#include "oracle/mechanics.hpp"
#include "support/models.hpp"

using namespace elgen;
using namespace elgen::test;
using cln::cl_R;
using cln::cl_RA;

namespace {

/// T = 1/2 m (dr^2 + r^2 dp^2), V = k r, input u on r.
const std::string rotating_pipe = model_text("polar", R"toml(
[[coordinate]]
name = "r"
[[coordinate]]
name = "p"
[parameters]
m = 2
k = 3
[energy]
T = "1/2*m*(dot(r)^2 + r^2*dot(p)^2)"
V = "k*r"
[[input]]
name = "u"
on = "r"
)toml");

const std::string forced_pendulum = model_text("pendulum", R"toml(
[[coordinate]]
name = "q"
[parameters]
m = 2
k = 3
[energy]
T = "1/2*m*(1 + q^2)*dot(q)^2"
V = "k*(1 - cos(q))"
[[input]]
name = "u"
[[force]]
on = "q"
value = "u*exp(q)"
)toml");

/// q = 1/5, v = 1/7, a = 1/3, u = 1/2
State some_state(const CheckedModel& checked) {
  State state = nominal_state(checked.model, checked.scene);
  state.q[0] = cl_RA(1) / 5;
  state.v[0] = cl_RA(1) / 7;
  state.a[0] = cl_RA(1) / 3;
  state.u[0] = cl_RA(1) / 2;
  return state;
}

cl_R value(const CheckedModel& checked, OutputKind kind) {
  return oracle_values(checked.model, {.kind = kind}, some_state(checked))->front();
}

bool near(const cl_R& x, const cl_R& y) { return cln::abs(x - y) < cln::expt(cl_R(10), -50); }

}  // namespace

TEST_CASE("reaction force in a rotating pipe: m r'' - m r p'^2 + k") {
  const CheckedModel held =
      checked_scene(rotating_pipe, "[lock]\nr = { value = \"t^3\", reaction = true }\n");
  State state = nominal_state(held.model, held.scene);
  state.v = {5};
  state.a = {7};
  CHECK(state.u.empty());  // the scene has no input along the pipe
  state.t = 2;
  // r = 8, dr/dt = d2r/dt2 = 12: m r'' = 24, m r p'^2 = 400
  const OracleValues force = oracle_values(held.model, {.kind = OutputKind::reaction}, state);
  CHECK(force.value() == std::vector<cln::cl_R>{24 - 400 + 3});
}

TEST_CASE("a lock without reaction has no output row") {
  const CheckedModel held = checked_scene(rotating_pipe, "[lock]\nr = { value = 1 }\n");
  const State state = nominal_state(held.model, held.scene);
  CHECK(oracle_values(held.model, {.kind = OutputKind::reaction}, state).value().empty());
}

TEST_CASE("a locked coordinate contributes its energy of motion, including its armature") {
  const CheckedModel held = checked_scene(model_text("arm", R"toml(
[[coordinate]]
name = "a"
armature = "J"
[[coordinate]]
name = "b"
[parameters]
J = 3
[energy]
T = "1/2*dot(a)^2 + dot(a)*dot(b)*b + dot(b)^2*a"
V = "a*b"
)toml"),
                                          "[lock]\na = { value = \"3*t^2\" }\n");
  State state = nominal_state(held.model, held.scene);
  state.q = {5};
  state.v = {11};
  state.t = 2;
  const auto value = [&](OutputKind kind) {
    return oracle_values(held.model, {.kind = kind}, state).value().front();
  };
  // a = 12, da/dt = 12
  CHECK(value(OutputKind::potential_energy) == 60);
  CHECK(value(OutputKind::mass_matrix) == 24);
  CHECK(value(OutputKind::kinetic_energy) == 72 + 12 * 11 * 5 + 121 * 12 + 3 * 72);
}

TEST_CASE("an exact model has no expansion point") {
  const CheckedModel checked = checked_model(forced_pendulum);
  CHECK_FALSE(oracle::expansion_point(checked.model, some_state(checked)).has_value());
}

TEST_CASE("outputs follow from the Taylor polynomials of the energies") {
  const CheckedModel linear = approximated(forced_pendulum, "order = 1\nabout = { q = 0 }");
  CHECK(near(value(linear, OutputKind::mass_matrix), 2));
  CHECK(near(value(linear, OutputKind::potential_energy), cl_RA(3) / 2 / 25));
  CHECK(near(value(linear, OutputKind::inverse_dynamics), cl_RA(2) / 3 + cl_RA(3) / 5));
  CHECK(near(value(linear, OutputKind::input_matrix), 1));
  const CheckedModel third = approximated(forced_pendulum, "order = 3\nabout = { q = 0 }");
  const cl_R q = cl_RA(1) / 5;
  CHECK(near(value(third, OutputKind::mass_matrix), 2 * (1 + q * q)));
  CHECK(near(value(third, OutputKind::potential_energy), 3 * (q * q / 2 - q * q * q * q / 24)));
  CHECK(near(value(third, OutputKind::input_matrix), 1 + q + q * q / 2));
}

TEST_CASE("forces on coordinates that are not small keep one more order") {
  const CheckedModel second = approximated(model_text("cart", R"toml(
[[coordinate]]
name = "th"
[[coordinate]]
name = "x"
[energy]
T = "dot(x)^2 + dot(th)^2"
V = "cosh(th)"
[[input]]
name = "u"
[[force]]
on = "x"
value = "u*sin(th)"
[[force]]
on = "th"
value = "u*(exp(th) - 1)"
)toml"),
                                           "order = 2\nabout = { th = 0 }");
  const OracleValues found =
      oracle_values(second.model, {.kind = OutputKind::input_matrix}, some_state(second));
  REQUIRE(found);
  const cl_R th = cl_RA(1) / 5;
  CHECK(near(found->at(0), th + th * th / 2));
  CHECK(near(found->at(1), th - th * th * th / 6));
}

TEST_CASE("small quantities go to the expansion point with s, others stay") {
  const CheckedModel checked = approximated(forced_pendulum, "order = 2\nabout = { q = 1, u = 3 }");
  const State state = some_state(checked);
  const auto point = oracle::expansion_point(checked.model, state);
  REQUIRE(point.has_value());
  const oracle::Motion motion = oracle::scale_towards(*point, oracle::make_motion(state), 2);
  CHECK(motion.q[0].real() == 1);
  CHECK(motion.v[0].real() == 0);
  CHECK(motion.u[0].real() == 3);
  CHECK(motion.q[0].sum_grades().real() == state.q[0]);
  CHECK(motion.parameters[0].real() == state.parameters[0]);
}
