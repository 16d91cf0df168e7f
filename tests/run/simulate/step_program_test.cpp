// Runs of verlet and midpoint: values by hand, known properties of their energies, and inputs held
// over a step.
#include <catch2/catch.hpp>
#include <cmath>

#include "run/simulate/compiled_model.hpp"
#include "support/shell.hpp"

using namespace elgen;
using namespace elgen::test;

TEST_CASE("one step of verlet has the values computed by hand") {
  // x = 1, v = 0, a = -4 x
  const auto last =
      CompiledSystem(read_model("spring")).trajectory(steps_of("verlet", 0.5, 0.5)).last;
  CHECK(last[1] == 0.5);
  CHECK(last[2] == -1.5);
}

TEST_CASE("a run calls the emitted step") {
  const std::string text = model_file("double_pendulum");
  const CompiledSystem compiled(text, {}, default_step(StepMethod::midpoint));
  const SimulationOptions options = steps_of("midpoint", 0.01, 1);
  const Result<Trajectory> run =
      simulate(compiled.checked(), compiled.program(), &compiled.functions(), options);
  REQUIRE(run);
  CHECK(run->last == compiled.trajectory(options).last);
}

TEST_CASE("verlet on an oscillator conserves p^2 + q^2 (1 - h^2/4)") {
  const CompiledSystem spring(read_model("spring"), start_options("", "", "k=1"));
  const Trajectory run = spring.trajectory(steps_of("verlet", 0.1, 1000));
  const double x = run.last[1];
  const double v = run.last[2];
  CHECK(v * v + x * x * (1 - 0.0025) == Approx(1 - 0.0025).epsilon(1e-12));
  // From q = 1, p = 0 the bound on |E - E0|/E0 is h^2/4.
  CHECK(run.energy.worst == Approx(0.0025).epsilon(1e-3));
}

TEST_CASE("the pendulum's energy oscillates without drift") {
  const CompiledSystem pendulum(read_model("free_pendulum"));
  for (const auto& [method, swing, drift] :
       {std::tuple{"verlet", 1.036e-3, 1e-5}, std::tuple{"midpoint", 8.591e-5, 1e-6}}) {
    INFO(method);
    const Trajectory run =
        pendulum.trajectory(steps_of(method, pendulum_period / 100, 1000 * pendulum_period));
    CHECK(run.steps == 100000);
    CHECK(run.energy.worst == Approx(swing).epsilon(0.02));
    // A tenth of the run is 100 periods, up to one step. The mean of a tenth is therefore accurate
    // to 1e-2 of the oscillation. A single run of 1e6 periods gave a drift of 1.2e-10.
    CHECK(std::abs(run.energy.secular) < drift);
  }
}

TEST_CASE("midpoint conserves an oscillator's energy: the rule rotates (q, p)") {
  const CompiledSystem spring(read_model("spring"));
  const Trajectory run = spring.trajectory(steps_of("midpoint", 0.1, 1000));
  CHECK(run.energy.worst < 1e-12);
}

TEST_CASE(
    "with midpoint a heavy top does not drift, and cyclic momenta are constant up to rounding") {
  const CompiledSystem top(model_file("heavy_top"));
  const Trajectory run = top.trajectory(steps_of("midpoint", 0.001, 20));
  CHECK(run.steps == 20000);
  CHECK(std::abs(run.energy.secular) < 1e-9);
  CHECK(run.energy.worst < 2e-9);
  REQUIRE(run.momenta.size() == 2);
  CHECK(run.momenta[0].name == "phi");
  for (const Drift& momentum : run.momenta) CHECK(momentum.worst < 1e-11);
}

TEST_CASE("midpoint evaluates forces and their work at the midpoint") {
  const CompiledSystem damped(read_model("spring") +
                              "[[force]]\non = \"x\"\nvalue = \"-1/2*dot(x)\"\n");
  const auto run = [&](double step) { return damped.trajectory(steps_of("midpoint", step, 5)); };
  // x = exp(-t/4) (cos w t + sin(w t)/(4 w)), w^2 = 4 - 1/16
  const double w = std::sqrt(4 - 1.0 / 16);
  const double exact = std::exp(-1.25) * (std::cos(5 * w) + std::sin(5 * w) / (4 * w));
  const double error = run(0.01).last[1] - exact;
  CHECK(std::abs(error) < 1e-3);
  CHECK(error / (run(0.005).last[1] - exact) == Approx(4).epsilon(0.02));
  // E - W is exact for a quadratic V, because the rule evaluates the power at the midpoint.
  CHECK(run(0.01).energy.worst < 1e-12);
}

TEST_CASE("the work of forces and of time has the order of the method") {
  const CompiledSystem driven(read_model("spring"), start_options("", "u=sin(3*t)"));
  const CompiledSystem stiffened(model_text("stiffened", R"toml([[coordinate]]
name = "x"
start = { value = 1, rate = 0.3 }
[energy]
T = "1/2*dot(x)^2"
V = "1/2*x^2*(1 + sin(t)/4)"
)toml"));
  for (const CompiledSystem* system : {&driven, &stiffened}) {
    const auto worst = [&](double step) {
      return system->trajectory(steps_of("verlet", step, 20)).energy.worst;
    };
    CHECK(worst(0.01) < 1e-3);
    CHECK(worst(0.01) / worst(0.005) == Approx(4).epsilon(0.1));
  }
}

TEST_CASE("during a step an input has its law's value at the start of the step") {
  // x'' = -1 in the first step, -31/32 in the second.
  const CompiledSystem held(read_model("spring"), start_options("", "u=-x", "k=0"));
  for (const char* method : {"verlet", "midpoint"}) {
    INFO(method);
    const Trajectory run =
        held.trajectory({.method = method, .duration = 0.5, .step = 0.25, .row_interval = 0.25});
    CHECK(run.last[1] == Approx(0.8759765625).epsilon(1e-14));
    CHECK(run.last[2] == Approx(-0.25 - 0.96875 / 4).epsilon(1e-14));
    // A row contains the input of the step that starts at the time of the row.
    CHECK(run.rows[1][3] == Approx(-0.96875).epsilon(1e-14));
  }
}

TEST_CASE("a law may depend on rates: it is a constant force during a step") {
  const CompiledSystem damped(read_model("spring"), start_options("", "u=-dot(x)/2"));
  const Trajectory run = damped.trajectory(steps_of("verlet", 0.001, 5));
  CHECK(std::abs(run.last.back()) < 0.5);
  CHECK(run.energy.worst < 1e-4);
}

TEST_CASE("E622: a method that does not suit the system") {
  const CompiledSystem particle(model_text("particle", R"toml([[coordinate]]
name = "x"
[energy]
L = "-sqrt(1 - dot(x)^2)"
)toml"));
  const Result<Trajectory> run = particle.run(steps_of("midpoint", 0.01, 10));
  REQUIRE_FALSE(run);
  CHECK(mentions(
      format(run.diagnostics),
      "[E622]: `midpoint` does not apply to this system: L is not quadratic in the rates"));
}

TEST_CASE("a run ends if the equations of a step are not solved") {
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
  CHECK(run.diagnostics.front().message.starts_with("the equations of the step are not solved"));
}
