// Steps with values known in closed form.
#include <catch2/catch.hpp>

#include "elgen/step_methods.hpp"
#include "oracle/output_values.hpp"
#include "oracle/samples.hpp"

namespace elgen::test {
namespace {

using Values = std::vector<cln::cl_R>;

Values step_of(const ModelBuilder& b, StepMethod method, const State& state,
               std::uint32_t iterations = 0) {
  const OutputRequest request{.kind = OutputKind::step,
                              .step = StepSpec{.method = method, .iterations = iterations}};
  return oracle::take_step(b.model, request, state);
}

/// x'' = -x with x = 1 and v = 0 at the start, h = 1/2.
ModelBuilder spring() {
  ModelBuilder b;
  b.coordinate("x").T("x_d^2/2").V("x^2/2");
  return b;
}

State at_one(const ModelBuilder& b) {
  State state = nominal_state(b.model, {});
  state.q = {1};
  state.h = exact("1/2");
  return state;
}

}  // namespace

TEST_CASE("rk4 of a linear system is its Taylor polynomial of degree 4") {
  const ModelBuilder b = spring();
  // 1 - h^2/2 + h^4/24, -h + h^3/6
  const Values expected{exact("337/384"), exact("-23/48")};
  CHECK(step_of(b, StepMethod::rk4, at_one(b)) == expected);
}

TEST_CASE("verlet updates the rate by half a step, the position, and the rate again") {
  const ModelBuilder b = spring();
  // v = -1/4, x = 7/8, v = -1/4 - 7/32
  const Values expected{exact("7/8"), exact("-15/32")};
  CHECK(step_of(b, StepMethod::verlet, at_one(b)) == expected);
}

TEST_CASE("a composition performs its substeps in order") {
  const ModelBuilder b = spring();
  State part = at_one(b);
  for (const cln::cl_RA& length : composition_coefficients(4)) {
    part.h = length * at_one(b).h;
    const Values next = step_of(b, StepMethod::verlet, part);
    part.q = {next[0]};
    part.v = {next[1]};
  }
  const OutputRequest request{.kind = OutputKind::step,
                              .step = default_step(StepMethod::verlet, 4)};
  CHECK(oracle::take_step(b.model, request, at_one(b)) == Values{part.q[0], part.v[0]});
}

TEST_CASE("a projected step ends on the constraints at its end time") {
  ModelBuilder b;
  b.coordinate("x").coordinate("y").T("x_d^2/2 + y_d^2/2").constraint("y - t*x");
  State state = nominal_state(b.model, {});
  state.q = {1, 0};
  state.t = 1;
  state.h = exact("1/2");
  const OutputRequest request{.kind = OutputKind::step, .step = StepSpec{.projects = true}};
  // At t = 3/2 the constraint is y = 3/2 x, and its rate dy = x + 3/2 dx.
  const Values next = oracle::take_step(b.model, request, state);
  CHECK(agree(next[1], next[0] * 3 / 2, 50));
  CHECK(agree(next[3], next[0] + next[2] * 3 / 2, 50));
  const Values drifted = step_of(b, StepMethod::rk4, state);
  CHECK_FALSE(agree(drifted[1], drifted[0] * 3 / 2, 5));
}

TEST_CASE("midpoint iterates as often as requested and returns the residual") {
  const ModelBuilder b = spring();
  // The midpoint rates are w = 0, -1/4, -15/64 in turn. The last midpoint is x = 241/256 with the
  // residual w + x/4 = 1/1024.
  const Values expected{exact("113/128"), exact("-241/512"), exact("1/1024")};
  CHECK(step_of(b, StepMethod::midpoint, at_one(b), 2) == expected);
}

TEST_CASE("midpoint conserves quadratic energies with terms linear in the rates") {
  ModelBuilder b;
  b.coordinate("x").coordinate("y").T("x_d^2/2 + y_d^2/2").V("-x*y_d");
  State state = nominal_state(b.model, {});
  state.v = {3, 4};
  state.h = exact("1/10");
  const Values next = step_of(b, StepMethod::midpoint, state, 20);
  CHECK(agree(next[2] * next[2] + next[3] * next[3], 25, 20));
  CHECK(agree(next[4], 0, 20, 1));
}

TEST_CASE("midpoint evaluates forces, dampers and time at the midpoint") {
  ModelBuilder b;
  b.coordinate("x").input("u").T("x_d^2/2").V("-t^2*x").D("x_d^2/2").force_on(0, "u");
  State state = nominal_state(b.model, {});
  state.u = {3};
  state.t = 1;
  state.h = 2;
  // w = h/2 (t_m^2 + u - w), iterated from 0: 7, then 0. At the end x = h w = 0, p = h (7 - 0) and
  // the residual is w - (7 - w) = -7.
  CHECK(step_of(b, StepMethod::midpoint, state, 2) == Values{0, 14, -7});
}

TEST_CASE("time advances within the step, inputs stay constant") {
  ModelBuilder b;
  b.coordinate("x").input("u").T("x_d^2/2").V("-t^2*x").force_on(0, "u");
  State state = nominal_state(b.model, {});
  state.u = {3};
  state.t = 1;
  state.h = 2;
  // x'' = t^2 + 3, integrated exactly: int_1^3 (t^2 + 3) dt and int_1^3 (3 - t) (t^2 + 3) dt
  CHECK(step_of(b, StepMethod::rk4, state) == Values{12, exact("44/3")});
}

TEST_CASE("a body spinning about an axis turns its quaternion by half the angle, to order 4") {
  ModelBuilder b;
  b.rotation("e").T("(e1_d^2 + e2_d^2 + e3_d^2)/2");
  State state = nominal_state(b.model, {});
  state.v = {0, 0, 1};
  state.h = exact("1e-3");
  const Values next = step_of(b, StepMethod::rk4, state);
  CHECK(agree(next[0] * next[0] + next[3] * next[3], 1, 80));
  CHECK(
      agree(next[3] / next[0], cln::tan(cln::cl_float(exact("5e-4"), cln::float_format(60))), 12));
  CHECK(next[6] == 1);
}

}  // namespace elgen::test
