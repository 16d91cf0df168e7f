// Steps: their order, their values beside runs of the same methods, what they are refused for.
#include "elgen/integrate.hpp"

#include <catch2/catch.hpp>

#include "integrate/stepping.hpp"
#include "simulate/compiled_model.hpp"
#include "support/shell.hpp"

namespace elgen::test {
namespace {

std::string model_file(const std::string& name) {
  return read_text(std::string(ELGEN_SOURCE_DIR) + "/models/" + name + ".toml");
}

/// A pendulum on a pivot that is shaken, and pushed.
const std::string shaken = model_text("shaken", R"toml([[coordinate]]
name = "x"
[[coordinate]]
name = "y"
[parameters]
k = 4
[energy]
T = "1/2*dot(x)^2 + 1/2*dot(y)^2"
V = "1 - cos(x - 1/2*sin(3*t)) + k*x*y^2"
[[input]]
name = "u"
on = "y"
)toml");

State somewhere(const Stepped& step) {
  State state = step.origin();
  const cln::cl_RA part = cln::cl_RA(1) / 7;
  for (std::size_t i = 0; i < state.q.size(); ++i) state.q[i] = state.q[i] + part * (1 + i);
  for (std::size_t i = 0; i < state.v.size(); ++i) state.v[i] = 1 - part * (3 * i);
  for (std::size_t i = 0; i < state.u.size(); ++i) state.u[i] = part * (5 + i);
  state.t = part * 2;
  make_unit_quaternions(step.model(), state);
  return state;
}

std::string refusal(const std::string& model, const std::string& method) {
  return format(stepped(model, method).diagnostics);
}

}  // namespace

TEST_CASE("one step of rk4 is off by h^5, of verlet by h^3") {
  const cln::cl_RA h = cln::cl_RA(1) / 100;
  for (const char* const name : {"cart_pole", "two_link_arm", "furuta_pendulum", "free_body"}) {
    INFO(name);
    const Stepped step(model_file(name), "rk4");
    CHECK(local_order(step, somewhere(step), h) == Approx(5).margin(0.15));
  }
  const Stepped rk4(shaken, "rk4");
  CHECK(local_order(rk4, somewhere(rk4), h) == Approx(5).margin(0.15));
  const Stepped verlet(shaken, "verlet");
  CHECK(local_order(verlet, somewhere(verlet), h) == Approx(3).margin(0.15));
}

TEST_CASE("a step is that of a run by the same method, but for rounding") {
  const CompiledSystem compiled(shaken, start_options("x=0.3,y=-0.2,dot(x)=1,dot(y)=2", "u=0.5"));
  for (const char* const method : {"rk4", "verlet"}) {
    INFO(method);
    SimulationOptions options = steps_of(method, 0.05, 0.05);
    options.from = 0.25;
    const std::vector<double> last = compiled.trajectory(options).last;
    const Stepped step(shaken, method);
    Arguments<double> at = arguments_at<double>(step.origin());
    at.q = {0.3, -0.2};
    at.v = {1, 2};
    at.u = {0.5};
    at.t = 0.25;
    at.h = 0.05;
    const std::vector<double> next = evaluate(step.program(), step.function(), at);
    for (std::size_t i = 0; i < next.size(); ++i) {
      CHECK(next[i] == Approx(last[i + 1]).epsilon(1e-14));  // behind t
    }
  }
}

TEST_CASE("verlet calls the accelerations twice, rk4 four times, and knows what they share") {
  const OperationCounts once = count_operations(Stepped(shaken, "verlet").function());
  const OperationCounts all = count_operations(Stepped(shaken, "rk4").function());
  // sin(3 t) in the middle is computed once.
  CHECK(once.sincos == 4);
  CHECK(all.sincos == 7);
}

TEST_CASE("quaternions stay of length 1, whatever the step is") {
  const Stepped step(model_file("quadrotor"), "rk4");
  State state = somewhere(step);
  state.h = 2;
  const std::vector<double> next = step.values<double>(state);
  double square = 0;
  for (std::size_t i = 3; i < 7; ++i) square += next[i] * next[i];
  CHECK(square == Approx(1).epsilon(1e-15));
}

TEST_CASE("a step of no length changes nothing") {
  const Stepped step(model_file("two_link_arm"), "rk4");
  const State state = somewhere(step);
  const std::vector<double> next = step.values<double>(state);
  const Arguments<double> at = arguments_at<double>(state);
  CHECK(std::vector<double>(next.begin(), next.begin() + 2) == at.q);
  CHECK(std::vector<double>(next.begin() + 2, next.end()) == at.v);
}

TEST_CASE("verlet is refused where it is not symplectic, and says why") {
  CHECK_THAT(refusal(model_file("cart_pole"), "verlet"),
             Catch::Contains("E622") &&
                 Catch::Contains("`verlet` is not for this system: M depends on `theta`") &&
                 Catch::Contains("next.scene.toml:5:1"));
  CHECK_THAT(refusal(model_file("free_body"), "verlet"), Catch::Contains("is a rotation"));
  CHECK_THAT(refusal(model_file("two_mass_damper"), "verlet"),
             Catch::Contains("a force depends on `dot(x1)`"));
}

TEST_CASE("a step calls the form that is asked for, and is judged by what it needs") {
  const CheckedModel checked = checked_model(shaken);
  OutputRequest step{.kind = OutputKind::step, .user = 1};
  step.form = Form::recursive;
  const std::vector<OutputRequest> needed = needed_for_step(checked.model, step);
  REQUIRE(needed.size() == 4);
  CHECK(needed[0].kind == OutputKind::mass_matrix);
  CHECK_FALSE(needed[0].form);
  CHECK(needed.back().kind == OutputKind::forward_dynamics);
  CHECK(needed.back().form == Form::recursive);
}

}  // namespace elgen::test
