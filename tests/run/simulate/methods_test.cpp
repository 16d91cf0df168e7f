// Methods: their names, refused options, orders, and tolerances.
#include "run/steps/methods.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <map>
#include <utility>

#include "run/simulate/compiled_model.hpp"

using namespace elgen;
using namespace elgen::test;

namespace {

std::string message(const Diagnostics& diagnostics) {
  if (diagnostics.empty()) return "";
  const Diagnostic& first = diagnostics.front();
  return std::string(code_row(first.code).name) + " " + first.message +
         (first.hint.empty() ? "" : " | " + first.hint);
}

std::string rule_of(const SimulationOptions& options) {
  return message(step_rule(*find_method(options), options).diagnostics);
}

}  // namespace

TEST_CASE("every method has its known order") {
  const std::map<std::string_view, double> orders{
      {"rk4", 4}, {"dopri5", 5}, {"verlet", 2}, {"midpoint", 2}};
  REQUIRE(orders.size() == method_table().size());
  const CompiledSystem pendulum(read_model("free_pendulum"));
  for (const MethodRow& method : method_table()) {
    INFO(method.name);
    const auto error = [&](double step) {
      const auto last =
          pendulum.trajectory(steps_of(std::string(method.name), step, pendulum_period)).last;
      return std::hypot(last[1] - 1, last[2]);
    };
    // With these steps neither rounding nor the next order is noticeable.
    const double length = pendulum_period / 100;
    const double order = std::log2(error(length) / error(length / 2));
    CHECK(order > orders.at(method.name) - 0.3);
    CHECK(order < orders.at(method.name) + 1.3);
  }
}

TEST_CASE("methods are found by name") {
  CHECK(find_method({.method = "rk4"})->name == "rk4");
  CHECK(message(find_method({.method = "rk5"}).diagnostics) ==
        "E620 unknown method `rk5` | did you mean `rk4`?");
  for (const std::string name : {"gauss", "euler", "fehlberg78"}) {
    CHECK(message(find_method({.method = name}).diagnostics) ==
          "E620 unknown method `" + name + "` | one of rk4, dopri5, verlet, midpoint");
  }
}

TEST_CASE("an order is accepted only if the method has it") {
  CHECK(find_method({.method = "rk4", .order = 4})->order == 4);
  CHECK(message(find_method({.method = "rk4", .order = 8}).diagnostics) ==
        "E647 `rk4` has no order 8 | it has 4");
  CHECK(message(find_method({.method = "dopri5", .order = 4}).diagnostics) ==
        "E647 `dopri5` has no order 4 | it has 5");
  CHECK(message(find_method({.method = "verlet", .order = 3}).diagnostics) ==
        "E647 `verlet` has no order 3 | it has 2, 4, 8");
}

TEST_CASE("compositions have the requested order") {
  const CompiledSystem pendulum(read_model("free_pendulum"));
  for (const std::string name : {"verlet", "midpoint"}) {
    for (const auto& [order, steps] : {std::pair{4U, 40}, std::pair{8U, 12}}) {
      INFO(name << " of order " << order);
      const auto error = [&, order = order](double step) {
        SimulationOptions options = steps_of(name, step, pendulum_period);
        options.order = order;
        const auto last = pendulum.trajectory(options).last;
        return std::hypot(last[1] - 1, last[2]);
      };
      const double length = pendulum_period / steps;
      CHECK(std::log2(error(length) / error(length / 2)) == Approx(order).margin(0.8));
      SimulationOptions options = steps_of(name, length, length);
      options.order = order;
      CHECK(pendulum.trajectory(options).method == name + " of order " + std::to_string(order));
    }
  }
}

TEST_CASE("runs of verlet and midpoint use the output `step`") {
  CHECK(step_for_run({.method = "verlet"}) == default_step(StepMethod::verlet));
  CHECK(step_for_run({.method = "verlet", .order = 2}) == default_step(StepMethod::verlet));
  CHECK(step_for_run({.method = "midpoint", .order = 8}) == default_step(StepMethod::midpoint, 8));
  for (const char* name : {"rk4", "dopri5", "rk5"}) CHECK_FALSE(step_for_run({.method = name}));
}

TEST_CASE(
    "times, steps and tolerances must be positive, and only one of step and tolerance is given") {
  CHECK(rule_of({.duration = 1}).empty());
  CHECK(step_rule(*find_method({}), {.duration = 1})->tolerance == 1e-9);
  CHECK(rule_of({.duration = -1}) == "E621 `--time -1` is not a positive number");
  CHECK(rule_of({.from = 1.0 / 0.0, .duration = 1}) == "E621 `--from inf` is not a number");
  CHECK(rule_of({.duration = 1, .step = 0}) == "E621 `--step 0` is not a positive number");
  CHECK(rule_of({.duration = 1, .tolerance = 0}) ==
        "E621 `--tolerance 0` is not a positive number");
  CHECK(rule_of({.duration = 1, .input_hold_time = -2}) ==
        "E621 `--hold -2` is not a positive number");
  CHECK(rule_of({.duration = 1, .step = 0.1, .tolerance = 0.1}) ==
        "E621 give `--step` or `--tolerance`, not both");
  CHECK(rule_of({.duration = 1, .row_interval = 2}) ==
        "E621 `--every 2` is longer than the whole run, `--time 1`");
  CHECK(rule_of({.method = "rk4", .duration = 1}) == "E621 `rk4` needs a step | give it `--step`");
  CHECK(rule_of({.method = "rk4", .duration = 1, .tolerance = 1e-3}) ==
        "E621 `rk4` does not choose its steps by a tolerance | give `--step`, or use `dopri5`");
}

TEST_CASE("a smaller tolerance gives a smaller error with more steps") {
  const CompiledSystem pendulum(read_model("free_pendulum"));
  const auto run = [&](double tolerance) {
    return pendulum.trajectory({.duration = pendulum_period, .tolerance = tolerance});
  };
  const auto error = [](const Trajectory& t) { return std::hypot(t.last[1] - 1, t.last[2]); };
  const Trajectory rough = run(1e-6);
  const Trajectory fine = run(1e-12);
  CHECK(error(rough) < 1e-4);
  CHECK(error(fine) < 1e-10);
  CHECK(fine.steps > rough.steps);
  CHECK(fine.last[0] == pendulum_period);
}

TEST_CASE("rk4 loses 9.03e-8 of the pendulum's energy per period of a hundred steps") {
  const CompiledSystem pendulum(read_model("free_pendulum"));
  const Trajectory run =
      pendulum.trajectory(steps_of("rk4", pendulum_period / 100, 100 * pendulum_period));
  CHECK(run.steps == 10000);
  CHECK(run.energy.worst == Approx(9.03e-6).epsilon(0.01));
  // The mean of the last tenth minus the mean of the first tenth: nine tenths of the loss.
  CHECK(run.energy.secular == Approx(-0.9 * 9.03e-6).epsilon(0.01));
}

TEST_CASE("a run ends if no step meets its tolerance") {
  const CompiledSystem compiled(model_text("wall", R"toml([[coordinate]]
name = "x"
start = { value = 1, rate = 0 }
[energy]
T = "1/2*dot(x)^2"
V = "-1/x^2"
)toml"));
  const Result<Trajectory> run = compiled.run({.duration = 2});
  REQUIRE_FALSE(run);
  CHECK(run.diagnostics.front().code == Code::E624);
  const Result<ReferenceRun> reference = run_reference(compiled.checked(), compiled.program(), 2);
  REQUIRE_FALSE(reference);
  CHECK(reference.diagnostics.front().code == Code::E624);
}

TEST_CASE("quaternions keep their length") {
  const CompiledSystem compiled(model_text("body", R"toml([[coordinate]]
name = "e"
kind = "rotation"
start = { value = [1, 0, 0, 0], rate = [1, 0.01, 0] }
[parameters]
J = 1
[[frame]]
name = "F"
parent = "world"
rotation = "e"
[[body]]
name = "B"
frame = "F"
inertia = ["2*J", "J", "3*J"]
)toml"));
  for (const SimulationOptions& options :
       {steps_of("rk4", 0.01, 20), SimulationOptions{.duration = 20}}) {
    const Trajectory run = compiled.trajectory(options);
    INFO(run.method);
    double square = 0;
    for (std::size_t i = 1; i <= 4; ++i) square += run.last[i] * run.last[i];
    CHECK(std::abs(square - 1) < 1e-15);
    CHECK(run.energy.worst < 1e-7);
  }
  const Result<ReferenceRun> reference = run_reference(compiled.checked(), compiled.program(), 20);
  REQUIRE(reference);
  double square = 0;
  for (std::size_t i = 0; i < 4; ++i) square += reference->last[i] * reference->last[i];
  CHECK(std::abs(square - 1) < 1e-15);
}
