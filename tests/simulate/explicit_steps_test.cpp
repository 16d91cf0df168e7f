// The symplectic methods that are explicit, against what is known of them exactly.
#include <catch2/catch.hpp>
#include <cmath>

#include "simulate/compiled_model.hpp"

using namespace elgen;
using namespace elgen::test;

TEST_CASE("one step of each by hand") {
  const CompiledSystem spring(spring_text());
  // x = 1, v = 0, a = -4 x
  const auto euler = spring.trajectory(steps_of("euler", 0.5, 0.5)).last;
  CHECK(euler[2] == -2);
  CHECK(euler[1] == 0);
  const auto verlet = spring.trajectory(steps_of("verlet", 0.5, 0.5)).last;
  CHECK(verlet[1] == 0.5);
  CHECK(verlet[2] == -1.5);
}

TEST_CASE("verlet on an oscillator conserves p^2 + q^2 (1 - h^2/4)") {
  const CompiledSystem spring(spring_text(), start_options("", "", "k=1"));
  const Trajectory run = spring.trajectory(steps_of("verlet", 0.1, 1000));
  const double x = run.last[1];
  const double v = run.last[2];
  CHECK(v * v + x * x * (1 - 0.0025) == Approx(1 - 0.0025).epsilon(1e-12));
  // The bound on |E - E0| / E0 from q = 1, p = 0.
  CHECK(run.energy.worst == Approx(0.0025).epsilon(1e-3));
}

TEST_CASE("verlet's energy swings by 1.036e-3 and does not drift") {
  const CompiledSystem pendulum(pendulum_text());
  const Trajectory run =
      pendulum.trajectory(steps_of("verlet", pendulum_period / 100, 1e4 * pendulum_period));
  CHECK(run.steps == 1000000);
  CHECK(run.energy.worst == Approx(1.036e-3).epsilon(0.02));
  // A tenth of the run is a whole number of periods but for a phase of one step, so its mean is
  // known to 1e-3 of the swing in 1e3 periods. 1e6 periods, run once, gave 1.2e-10.
  CHECK(std::abs(run.energy.secular) < 1e-6);
}

TEST_CASE("semi-implicit euler's energy swings by 3.25e-2") {
  const CompiledSystem pendulum(pendulum_text());
  const Trajectory run =
      pendulum.trajectory(steps_of("euler", pendulum_period / 100, 1000 * pendulum_period));
  const double start = 1 - std::cos(1);
  CHECK(run.energy.worst * run.energy.scale / start == Approx(3.25e-2).epsilon(0.02));
  CHECK(std::abs(run.energy.secular) < 1e-4);
}

TEST_CASE("work of forces is counted to the order of the method") {
  const CompiledSystem driven(spring_text(), start_options("", "u=sin(3*t)"));
  const auto worst = [&](const char* method, double step) {
    return driven.trajectory(steps_of(method, step, 20)).energy.worst;
  };
  CHECK(worst("verlet", 0.01) < 1e-3);
  CHECK(worst("verlet", 0.01) / worst("verlet", 0.005) == Approx(4).epsilon(0.05));
  CHECK(worst("euler", 0.01) / worst("euler", 0.005) == Approx(2).epsilon(0.1));
}
