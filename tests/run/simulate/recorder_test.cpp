// Recorded rows of samples, and drifts of known sequences of numbers.
#include "run/simulate/recorder.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "run/simulate/compiled_model.hpp"

using namespace elgen;
using namespace elgen::test;

namespace {

const std::string wheel = model_text("wheel", R"toml([[coordinate]]
name = "turn"
unit = "rad"
wrap = true
[[coordinate]]
name = "x"
unit = "m"
[parameters]
J = { value = 2, unit = "kg*m^2" }
m = { value = 1, unit = "kg" }
[energy]
T = "1/2*J*dot(turn)^2 + 1/2*m*dot(x)^2"
)toml");

}  // namespace

TEST_CASE("rows contain wrapped angles, and momenta of cyclic coordinates") {
  const CompiledSystem compiled(wheel, start_options("dot(turn)=3"));
  SimulatedSystem system(compiled.checked(), compiled.program(), &compiled.functions());
  const SimulationOptions options{.duration = 1, .row_interval = 1};
  const TrajectorySample start{0, 0, true, system.start_state(), {}};
  Recorder recorder(system, options, start);
  CHECK(recorder.add_sample(start).empty());
  CHECK(recorder.add_sample({0.5, 0.5, false, {4, 1, 3, 0, 0}, {}}).empty());
  CHECK(recorder.add_sample({1, 0.5, true, {-4, 1, 3.5, 0, 0}, {}}).empty());
  Trajectory trajectory;
  std::move(recorder).move_results(trajectory);
  REQUIRE(trajectory.rows.size() == 2);
  CHECK(trajectory.rows[1][1] == Approx(2 * M_PI - 4));
  CHECK(trajectory.last == trajectory.rows[1]);
  CHECK(trajectory.last.back() == 12.25);
  REQUIRE(trajectory.momenta.size() == 2);
  CHECK(trajectory.momenta[0].worst == Approx(1.0 / 7));
  CHECK(trajectory.energy.worst == Approx(3.25 / 12.25));
  CHECK(trajectory.energy.name == "E - E0");
}

TEST_CASE("entries of `conserved` are recorded with their text and unit") {
  const CompiledSystem compiled(
      wheel +
          "[[expect]]\nconserved = [\"E\", \"p(turn)\", \"\"\"\n  x -\n  t*dot(x)\"\"\", "
          "\"dot(dot(x))\"]\n",
      start_options("dot(turn)=3"));
  SimulatedSystem system(compiled.checked(), compiled.program(), &compiled.functions());
  const SimulationOptions options{.duration = 1};
  const TrajectorySample start{0, 0, false, system.start_state(), {}};
  Recorder recorder(system, options, start);
  CHECK(recorder.add_sample(start).empty());
  CHECK(recorder.add_sample({0.5, 0.5, false, {4, 1, 3.5, 0, 0}, {}}).empty());
  CHECK(recorder.add_sample({1, 0.5, false, {4, 1, 3, 2, 0}, {}}).empty());
  Trajectory trajectory;
  std::move(recorder).move_results(trajectory);
  REQUIRE(trajectory.conserved.size() == 4);
  CHECK(trajectory.conserved[0].unit == "J");
  CHECK(trajectory.conserved[0].start == 9);
  CHECK(trajectory.conserved[0].drift == 3.25);
  CHECK(trajectory.conserved[1].text == "p(turn)");
  CHECK(trajectory.conserved[1].unit == "kg*m^2/s");
  CHECK(trajectory.conserved[1].start == 6);
  CHECK(trajectory.conserved[1].drift == 1);
  CHECK(trajectory.conserved[2].text == "x - t*dot(x)");
  CHECK(trajectory.conserved[2].unit == "m");
  CHECK(trajectory.conserved[2].drift == 1);
  CHECK(trajectory.conserved[3].drift == 0);
}

TEST_CASE("a number that is not finite ends the run, with the last finite state") {
  const CompiledSystem compiled(wheel, start_options("dot(turn)=3"));
  SimulatedSystem system(compiled.checked(), compiled.program(), &compiled.functions());
  const SimulationOptions options{.duration = 1};
  const TrajectorySample start{0, 0, false, system.start_state(), {}};
  Recorder recorder(system, options, start);
  CHECK(recorder.add_sample(start).empty());
  const Diagnostics ended = recorder.add_sample({0.5, 0.5, false, {INFINITY, 1, 3, 0, 0}, {}});
  REQUIRE(ended.size() == 1);
  CHECK(ended.front().code == Code::E624);
  CHECK(ended.front().message ==
        "the numbers are no longer finite after t = 0, where turn = 0, x = 0, dot(turn) = 3, "
        "dot(x) = 0");
}

TEST_CASE("a drift has the worst magnitude, and the last tenth's mean minus the first tenth's") {
  DriftMeter meter;
  for (int i = 0; i <= 100; ++i) meter.add(i / 100.0, 1, -i, 50 + i);
  const Drift drift = meter.drift("E", "size");
  CHECK(drift.name == "E");
  CHECK(drift.measure == "size");
  CHECK(drift.scale == 150);
  CHECK(drift.worst == Approx(100.0 / 150));
  CHECK(drift.secular == Approx((-95.0 + 5) / 150));
}

TEST_CASE("means are weighted by the length of steps") {
  DriftMeter meter;
  meter.add(0, 0, 7, 1);
  meter.add(0.01, 3, 1, 1);
  meter.add(0.05, 1, 5, 1);
  meter.add(1, 2, 4, 1);
  CHECK(meter.drift("", "").secular == 4 - 2);
}

TEST_CASE("if all magnitudes are zero, the drift is absolute") {
  DriftMeter meter;
  meter.add(0, 0, 0, 0);
  meter.add(1, 1, 0, 0);
  CHECK(meter.drift("", "").scale == 1);
  CHECK(meter.drift("", "").worst == 0);
}

TEST_CASE("a multiplier has its unit, and the timed code is named") {
  const CompiledSystem system(model_text("sled", R"toml([[coordinate]]
name = "x"
unit = "m"
[[coordinate]]
name = "y"
unit = "m"
[parameters]
m = { value = 1, unit = "kg" }
[energy]
T = "1/2*m*(dot(x)^2 + dot(y)^2)"
[[constraint]]
name = "wall"
equation = "x = y"
)toml"));
  const SimulationOptions options = steps_of("rk4", 0.1, 0.1);
  const Result<Trajectory> run = simulate(system.checked(), system.program(), nullptr, options);
  REQUIRE(run);
  CHECK(run->columns[5].name == "lambda_wall");
  CHECK(run->columns[5].unit == "N");
  CHECK(run->timed_code == "in the evaluator");
  CHECK(system.trajectory(options).timed_code == "of the emitted C++");
}
