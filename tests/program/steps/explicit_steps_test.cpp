// Tests the orders of rk4 and verlet, and compares a step of rk4 with a simulated run.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

#include "elgen/step_methods.hpp"
#include "oracle/samples.hpp"
#include "program/steps/compiled_step.hpp"
#include "run/simulate/compiled_model.hpp"

namespace elgen::test {
namespace {

/// A pendulum whose length varies with time.
const std::string swinging = model_text("swinging", R"toml([[coordinate]]
name = "x"
start = { value = 0.6, rate = 0 }
[[coordinate]]
name = "y"
start = { value = -0.8, rate = 0 }
[energy]
T = "1/2*dot(x)^2 + 1/2*dot(y)^2"
V = "y"
[[constraint]]
name = "rod"
equation = "x^2 + y^2 = 1 + 1/2*sin(3*t)"
)toml");

}  // namespace

TEST_CASE("one step of rk4 has an error of O(h^5), of verlet O(h^3)") {
  const cln::cl_RA h = cln::cl_RA(1) / 100;
  for (const char* const name : {"cart_pole", "two_link_arm", "furuta_pendulum", "free_body"}) {
    INFO(name);
    const StepProgram step(model_file(name), "rk4");
    CHECK(local_order(step, generic_state(step), h) == Approx(5).margin(0.15));
  }
  const StepProgram rk4(shaken, "rk4");
  CHECK(local_order(rk4, generic_state(rk4), h) == Approx(5).margin(0.15));
  const StepProgram verlet(shaken, "verlet");
  CHECK(local_order(verlet, generic_state(verlet), h) == Approx(3).margin(0.15));
}

TEST_CASE("a projected step is the step followed by `projected`, bit by bit") {
  for (const std::string& model : {model_file("five_bar"), model_file("rolling_ball"), swinging}) {
    const StepProgram whole(model, "rk4", ", projected = true");
    State state = generic_state(whole);
    state.h = cln::cl_RA(1) / 100;
    const Products parts = stepped({model, "rk4", "", "projected = true\n"});
    REQUIRE(parts.program);
    Arguments<double> at = arguments_at<double>(state);
    const std::vector<double> moved = evaluate(*parts.program, parts.program->functions.back(), at);
    at.t += at.h;
    at.q.assign(moved.begin(), moved.begin() + static_cast<std::ptrdiff_t>(at.q.size()));
    at.v.assign(moved.begin() + static_cast<std::ptrdiff_t>(at.q.size()), moved.end());
    const Function& projected = *find_function(*parts.program, OutputKind::projected);
    CHECK(whole.values<double>(state) == evaluate(*parts.program, projected, at));
    CHECK(whole.values<double>(state) != moved);
    const OracleValues slow = oracle_values(
        whole.model(), {.kind = OutputKind::step, .step = whole.function().step}, state);
    REQUIRE(slow);
    const std::vector<cln::cl_R> exact_values = *to_oracle_values(whole.values<Real>(state));
    REQUIRE(slow->size() == exact_values.size());
    for (std::size_t i = 0; i < slow->size(); ++i) CHECK(agree((*slow)[i], exact_values[i], 40));
  }
}

TEST_CASE("one step of a composition has an error of O(h^(order + 1))") {
  const cln::cl_RA h = cln::cl_RA(1) / 100;
  for (const int order : {4, 8}) {
    const std::string more = ", order = " + std::to_string(order);
    const StepProgram verlet(shaken, "verlet", more);
    CHECK(local_order(verlet, generic_state(verlet), h) == Approx(order + 1).margin(0.15));
    const StepProgram midpoint(shaken, "midpoint", more + ", iterations = 10");
    CHECK(local_order(midpoint, generic_state(midpoint), h) == Approx(order + 1).margin(0.15));
  }
}

TEST_CASE("substeps of a composition are symmetric and meet the conditions of their order") {
  CHECK(composition_coefficients(0) == std::vector<cln::cl_RA>{1});
  for (const int order : {4, 8}) {
    const std::vector<cln::cl_RA> parts =
        composition_coefficients(static_cast<std::uint32_t>(order));
    CHECK(parts.size() == (order == 4 ? 5U : 17U));
    CHECK(std::vector<cln::cl_RA>(parts.rbegin(), parts.rend()) == parts);
    for (int power = 1; power < order; power += 2) {
      cln::cl_RA sum = power == 1 ? -1 : 0;
      for (const cln::cl_RA& part : parts) sum = sum + cln::expt(part, power);
      CHECK(std::abs(cln::double_approx(sum)) <= (power == 1 ? 0 : 1e-25));
    }
  }
}

TEST_CASE("1000 periods of an ellipse with e = 0.6 end within 1e-5 after 2.1e6 accelerations") {
  const std::string kepler = model_text("kepler", R"toml([[coordinate]]
name = "x"
start = { value = 0.4, rate = 0 }
[[coordinate]]
name = "y"
start = { value = 0, rate = 2 }
[energy]
T = "1/2*dot(x)^2 + 1/2*dot(y)^2"
V = "-1/sqrt(x^2 + y^2)"
)toml");
  // The kicks of adjacent substeps are merged.
  const std::size_t accelerations =
      count_operations(StepProgram(kepler, "verlet", ", order = 8").function()).sqrt;
  CHECK(accelerations == 18);
  const int steps = 116 * 1000;
  CHECK(static_cast<double>(steps) * static_cast<double>(accelerations) < 2.1e6);
  CompiledStep run({.model = kepler, .method = "verlet", .more = ", order = 8"});
  const double start = run.energy();
  double swing = 0;
  for (int i = 0; i < steps; ++i) {
    run.step(2 * std::numbers::pi / 116);
    if (i % 29 == 0) swing = std::max(swing, std::abs(run.energy() - start));
  }
  CHECK(std::hypot(run.at().q[0] - 0.4, run.at().q[1]) < 1e-5);
  CHECK(swing < 1e-9 * std::abs(start));
}

TEST_CASE("a step of rk4 agrees with an independent run up to rounding") {
  const CompiledSystem compiled(shaken, start_options("x=0.3,y=-0.2,dot(x)=1,dot(y)=2", "u=0.5"));
  SimulationOptions options = steps_of("rk4", 0.05, 0.05);
  options.from = 0.25;
  const std::vector<double> last = compiled.trajectory(options).last;
  const StepProgram step(shaken, "rk4");
  Arguments<double> at = arguments_at<double>(step.origin());
  at.q = {0.3, -0.2};
  at.v = {1, 2};
  at.u = {0.5};
  at.t = 0.25;
  at.h = 0.05;
  const std::vector<double> next = evaluate(step.program(), step.function(), at);
  for (std::size_t i = 0; i < next.size(); ++i) {
    CHECK(next[i] == Approx(last[i + 1]).epsilon(1e-14));  // last[0] is t
  }
}

TEST_CASE("verlet calls the accelerations twice, rk4 four times, with shared operations") {
  const OperationCounts once = count_operations(StepProgram(shaken, "verlet").function());
  const OperationCounts all = count_operations(StepProgram(shaken, "rk4").function());
  // sin(3 t) at the midpoint is computed once.
  CHECK(once.sincos == 4);
  CHECK(all.sincos == 7);
}

TEST_CASE("quaternions keep length 1 for any step size") {
  const StepProgram step(model_file("quadrotor"), "rk4");
  State state = generic_state(step);
  state.h = 2;
  const std::vector<double> next = step.values<double>(state);
  double square = 0;
  for (std::size_t i = 3; i < 7; ++i) square += next[i] * next[i];
  CHECK(square == Approx(1).epsilon(1e-15));
}

TEST_CASE("a step of length 0 changes nothing") {
  const StepProgram step(model_file("two_link_arm"), "rk4");
  const State state = generic_state(step);
  const std::vector<double> next = step.values<double>(state);
  const Arguments<double> at = arguments_at<double>(state);
  CHECK(std::vector<double>(next.begin(), next.begin() + 2) == at.q);
  CHECK(std::vector<double>(next.begin() + 2, next.end()) == at.v);
}

}  // namespace elgen::test
