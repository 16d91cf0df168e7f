// The implicit midpoint rule against what is known of it.
#include <catch2/catch.hpp>
#include <cmath>

#include "simulate/compiled_model.hpp"
#include "support/shell.hpp"

using namespace elgen;
using namespace elgen::test;

TEST_CASE("an oscillator keeps its energy: the rule is a rotation of (q, p)") {
  const CompiledSystem spring(spring_text());
  const Trajectory run = spring.trajectory(steps_of("midpoint", 0.1, 1000));
  CHECK(run.energy.worst < 1e-13);
}

TEST_CASE("the pendulum's energy swings by 8.59e-5") {
  const CompiledSystem pendulum(pendulum_text());
  const Trajectory run =
      pendulum.trajectory(steps_of("midpoint", pendulum_period / 100, 1000 * pendulum_period));
  CHECK(run.energy.worst == Approx(8.591e-5).epsilon(0.02));
  CHECK(std::abs(run.energy.secular) < 1e-6);
}

TEST_CASE("a heavy top does not drift, and its cyclic momenta stay to rounding") {
  const CompiledSystem top(read_text(std::string(ELGEN_SOURCE_DIR) + "/models/heavy_top.toml"));
  const Trajectory run = top.trajectory(steps_of("midpoint", 0.005, 500));
  CHECK(run.steps == 100000);
  // 5.6e-13 here, 9.3e-13 in 1e6 steps.
  CHECK(std::abs(run.energy.secular) < 1e-11);
  CHECK(run.energy.worst < 2e-8);
  REQUIRE(run.momenta.size() == 2);
  CHECK(run.momenta[0].name == "phi");
  for (const Drift& momentum : run.momenta) CHECK(momentum.worst < 1e-14);
}

TEST_CASE("forces act at the midpoint, half to each side") {
  const CompiledSystem damped(spring_text() + "[[force]]\non = \"x\"\nvalue = \"-1/2*dot(x)\"\n");
  const auto run = [&](double step) { return damped.trajectory(steps_of("midpoint", step, 5)); };
  // x = exp(-t/4) (cos w t + sin(w t)/(4 w)), w^2 = 4 - 1/16
  const double w = std::sqrt(4 - 1.0 / 16);
  const double exact = std::exp(-1.25) * (std::cos(5 * w) + std::sin(5 * w) / (4 * w));
  const double error = run(0.01).last[1] - exact;
  CHECK(std::abs(error) < 1e-3);
  CHECK(error / (run(0.005).last[1] - exact) == Approx(4).epsilon(0.02));
  // E - W is exact for a quadratic V, of which the rule takes the power at the midpoint.
  CHECK(run(0.01).energy.worst < 1e-13);
}

TEST_CASE("Lagrangians that are not quadratic in the rates, and that depend on time") {
  const CompiledSystem particle(model_text("particle", R"toml([[coordinate]]
name = "x"
start = { value = 1, rate = 0.3 }
[energy]
L = "-sqrt(1 - dot(x)^2) - 1/2*x^2*(1 + sin(t)/4)"
)toml"));
  const auto worst = [&](double step) {
    return particle.trajectory(steps_of("midpoint", step, 10)).energy.worst;
  };
  CHECK(worst(0.01) < 1e-4);
  CHECK(worst(0.01) / worst(0.005) == Approx(4).epsilon(0.05));
}

TEST_CASE("a step whose equations have no solution ends the run") {
  const CompiledSystem well(model_text("well", R"toml([[coordinate]]
name = "x"
start = { value = 1, rate = 0 }
[energy]
T = "1/2*dot(x)^2"
V = "-x^4"
)toml"));
  const Result<Trajectory> run = well.run(steps_of("midpoint", 0.5, 10));
  REQUIRE_FALSE(run);
  CHECK(run.diagnostics.front().code == Code::E624);
}
