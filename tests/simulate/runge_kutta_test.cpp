// Methods with an estimated error: the tolerance decides, and ends are met exactly.
#include <catch2/catch.hpp>
#include <cmath>

#include "simulate/compiled_model.hpp"

using namespace elgen;
using namespace elgen::test;

TEST_CASE("a smaller tolerance gives a smaller error by more steps") {
  const CompiledSystem pendulum(pendulum_text());
  for (const bool is_reference : {false, true}) {
    INFO(is_reference);
    const auto run = [&](double tolerance) {
      return pendulum.trajectory(
          {.is_reference = is_reference, .time = pendulum_period, .tolerance = tolerance});
    };
    const auto error = [](const Trajectory& t) { return std::hypot(t.last[1] - 1, t.last[2]); };
    const Trajectory rough = run(1e-6);
    const Trajectory fine = run(1e-12);
    CHECK(error(rough) < 1e-4);
    CHECK(error(fine) < 1e-10);
    CHECK(fine.steps > rough.steps);
    CHECK(fine.last[0] == pendulum_period);
  }
}

TEST_CASE("rk4 loses 9.03e-8 of the pendulum's energy in each period of a hundred steps") {
  const CompiledSystem pendulum(pendulum_text());
  const Trajectory run =
      pendulum.trajectory(steps_of("rk4", pendulum_period / 100, 100 * pendulum_period));
  CHECK(run.steps == 10000);
  CHECK(run.energy.worst == Approx(9.03e-6).epsilon(0.01));
  // From the middle of the first tenth to that of the last: nine tenths of it.
  CHECK(run.energy.secular == Approx(-0.9 * 9.03e-6).epsilon(0.01));
}

TEST_CASE("a tolerance that no step meets ends the run") {
  const CompiledSystem compiled(model_text("wall", R"toml([[coordinate]]
name = "x"
start = { value = 1, rate = 0 }
[energy]
T = "1/2*dot(x)^2"
V = "-1/x^2"
)toml"));
  const Result<Trajectory> run = compiled.run({.time = 2});
  REQUIRE_FALSE(run);
  CHECK(run.diagnostics.front().code == Code::E624);
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
       {steps_of("rk4", 0.01, 20), SimulationOptions{.time = 20},
        SimulationOptions{.is_reference = true, .time = 20}}) {
    const Trajectory run = compiled.trajectory(options);
    INFO(run.method);
    double square = 0;
    for (std::size_t i = 1; i <= 4; ++i) square += run.last[i] * run.last[i];
    CHECK(std::abs(square - 1) < 1e-15);
    CHECK(run.energy.worst < 1e-7);
  }
}
