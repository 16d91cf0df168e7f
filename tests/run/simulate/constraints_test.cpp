// Runs of models with constraints: comparison with minimal coordinates, drift off the constraints,
// work and conservation, and refused runs.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>

#include "run/simulate/compiled_model.hpp"
#include "run/steps/system.hpp"
#include "support/shell.hpp"

using namespace elgen;
using namespace elgen::test;

namespace {

/// A run in the evaluator; throws the diagnostics if it fails.
Trajectory evaluated(const CompiledSystem& system, const SimulationOptions& options) {
  Result<Trajectory> result = simulate(system.checked(), system.program(), nullptr, options);
  if (!result) throw std::runtime_error(format(result.diagnostics));
  return *result;
}

/// A bob on a rod of length 1.3, which starts at sin q = 5/13 with 2 rad/s.
const std::string bob_on_rod = model_text("bob", R"toml([[coordinate]]
name = "x"
start = { value = 0.5, rate = 2.4 }
[[coordinate]]
name = "y"
start = { value = -1.2, rate = 1 }
[parameters]
m = 2.1
g = 9.7
[energy]
T = "1/2*m*(dot(x)^2 + dot(y)^2)"
V = "m*g*y"
[[constraint]]
name = "rod"
equation = "x^2 + y^2 = 1.69"
)toml");

/// The bob on the rod with the angle q as its only coordinate: x = 1.3 sin q, y = -1.3 cos q.
const std::string bob_by_angle = model_text("bob", R"toml([[coordinate]]
name = "q"
start = { value = 0.39479111969976155, rate = 2 }
[parameters]
m = 2.1
g = 9.7
[energy]
T = "1/2*m*1.69*dot(q)^2"
V = "-m*g*1.3*cos(q)"
)toml");

/// Two coordinates of a model with m = 1; `rest` is appended.
std::string plane(const std::string& start_of_x, const std::string& rest) {
  return model_text("plane", "[[coordinate]]\nname = \"x\"\nstart = " + start_of_x +
                                 "\n[[coordinate]]\nname = \"y\"\n[parameters]\nm = 1\n" + rest);
}

const std::string free_in_plane = "[energy]\nT = \"1/2*m*(dot(x)^2 + dot(y)^2)\"\n";

}  // namespace

TEST_CASE("a pendulum in x and y agrees after 10 s with a pendulum in its angle") {
  const SimulationOptions options{.duration = 10, .tolerance = 1e-12};
  const Trajectory rod = CompiledSystem(bob_on_rod).trajectory(options);
  const Trajectory angle = CompiledSystem(bob_by_angle).trajectory(options);
  CHECK(std::abs(rod.last[1] - 1.3 * std::sin(angle.last[1])) < 1e-8);
  CHECK(std::abs(rod.last[2] + 1.3 * std::cos(angle.last[1])) < 1e-8);
  CHECK(rod.energy.name == "E - E0");
  CHECK(rod.energy.worst < 1e-9);
  REQUIRE(rod.constraints);
  CHECK(rod.constraints->largest.position <= 1e-12);
  CHECK(rod.constraints->start.empty());
  CHECK_FALSE(angle.constraints);
}

TEST_CASE("rows contain the multiplier of each constraint, after the inputs") {
  const CompiledSystem system(bob_on_rod + "[[input]]\nname = \"u\"\non = \"x\"\n",
                              start_options("", "u=8*t"));
  SimulationOptions options = steps_of("rk4", 0.01, 1);
  options.row_interval = options.input_hold_time = 0.25;
  const Trajectory run = evaluated(system, options);
  REQUIRE(run.columns.size() == 8);
  CHECK(run.columns[6].name == "lambda_rod");
  CHECK(run.columns[6].unit.empty());
  CHECK(run.columns[6].panel.empty());
  REQUIRE(run.rows.size() == 5);
  CHECK(run.rows.back()[5] == 6);
  for (const auto& row : run.rows) {
    // x x'' + y y'' = -v^2, with m x'' = u + 2 lambda x and m y'' = -m g + 2 lambda y.
    const double square = row[3] * row[3] + row[4] * row[4];
    const double outwards = row[5] * row[1] - 2.1 * 9.7 * row[2];
    CHECK(row[6] == Approx(-(2.1 * square + outwards) / (2 * 1.69)));
  }
  CHECK(run.last == run.rows.back());
}

TEST_CASE("a run stays on its constraints only with a projection after every step") {
  const CompiledSystem system(bob_on_rod);
  for (SimulationOptions options : {steps_of("rk4", 0.02, 10), steps_of("dopri5", 0.05, 10),
                                    SimulationOptions{.duration = 10, .tolerance = 1e-7}}) {
    INFO(options.method);
    const ConstraintViolation kept = evaluated(system, options).constraints->largest;
    CHECK(kept.position <= 1e-12);
    CHECK(kept.rate <= 1e-12);
    options.projects = false;
    const ConstraintViolation left = evaluated(system, options).constraints->largest;
    CHECK(left.position > 1e-10);
    CHECK(left.rate > 1e-10);
  }
}

TEST_CASE("a start off the constraints is moved onto them, and the report states the changes") {
  const CompiledSystem system(replaced(bob_on_rod, "0.5", "0.6"));
  const Trajectory run = evaluated(system, steps_of("rk4", 0.01, 0.1));
  const std::vector<StartCorrection>& start = run.constraints->start;
  REQUIRE(start.size() == 4);
  // Positions change along the rod; the rate along the rod becomes zero.
  const double stretch = 1.3 / std::sqrt(1.8);
  CHECK(start[0].name == "x");
  CHECK(start[0].change == Approx(0.6 * (stretch - 1)));
  CHECK(start[1].change == Approx(-1.2 * (stretch - 1)));
  CHECK(start[2].name == "dot(x)");
  CHECK(start[2].change == Approx(-0.08));
  CHECK(start[3].change == Approx(0.16));
  CHECK(mentions(
      to_text(run),
      "\n  start projected onto the constraints: x by -1.862e-02, y by +3.724e-02, dot(x) by "
      "-8.000e-02, dot(y) by +1.600e-01\n  constraints: residual at most "));
  CHECK(run.constraints->largest.position <= 1e-12);
}

TEST_CASE("stated values are fixed, and the others are solved for") {
  const CompiledSystem system(bob_on_rod, start_options("x=0.6, dot(y)=0.5"));
  const Numbers start = stated_start(assemble_start(system.checked(), 0)->model);
  CHECK(start[0] == 0.6);
  CHECK(std::abs(start[1] + std::sqrt(1.69 - 0.36)) < 1e-15);
  CHECK(std::abs(start[2] - 0.5 * std::sqrt(1.69 - 0.36) / 0.6) < 1e-15);
  CHECK(start[3] == 0.5);
}

TEST_CASE("joints of parallel robots are found from their platform or their motors") {
  const CompiledSystem platform(read_text(ELGEN_SOURCE_DIR "/tests/run/simulate/rrr.toml"),
                                start_options("x=0.05, y=0.02, phi=0.1, dot(x)=0.3"));
  const Trajectory run = evaluated(platform, {.duration = 1e-6, .row_interval = 1e-6});
  const std::vector<double>& start = run.rows.front();
  CHECK(start[1] == 0.05);
  CHECK(start[2] == 0.02);
  CHECK(start[3] == 0.1);
  CHECK(start[10] == 0.3);
  CHECK(run.constraints->largest.position < 1e-12);
  CHECK(run.constraints->largest.rate < 1e-12);
  for (std::size_t i = 4; i < 7; ++i) {
    const double turn = 2 * M_PI * static_cast<double>(i - 3) / 3;
    const double x = 0.05 + 0.15 * std::cos(0.1 + turn) - 0.6 * std::cos(turn);
    const double y = 0.02 + 0.15 * std::sin(0.1 + turn) - 0.6 * std::sin(turn);
    const double elbow_x = 0.4 * std::cos(start[i]);
    const double elbow_y = 0.4 * std::sin(start[i]);
    CHECK(std::abs(std::hypot(x - elbow_x, y - elbow_y) - 0.4) < 1e-12);
  }
  const CompiledSystem motors(model_file("five_bar"),
                              start_options("a1=2.2, a2=1, dot(a1)=1, dot(a2)=-2"));
  const Trajectory bars = evaluated(motors, {.duration = 1e-6, .row_interval = 1e-6});
  CHECK(bars.rows.front()[1] == 2.2);
  CHECK(bars.rows.front()[3] == 1);
  CHECK(bars.rows.front()[5] == 1);
  CHECK(bars.rows.front()[7] == -2);
  CHECK(bars.constraints->largest.position < 1e-12);
}

TEST_CASE("dependent rates follow from the stated rates") {
  const std::string disc = model_text("disc", R"toml([[coordinate]]
name = "x"
[[coordinate]]
name = "y"
[[coordinate]]
name = "roll"
start = { value = 0, rate = 1 }
[[coordinate]]
name = "head"
start = { value = 0.2, rate = 0 }
[parameters]
R = 0.4
[energy]
T = "3*(dot(x)^2 + dot(y)^2) + dot(roll)^2 + dot(head)^2 + dot(x)*dot(head)"
[[constraint]]
name = "grip"
kind = "velocity"
equation = ["dot(x) = R*cos(head)*dot(roll)", "dot(y) = R*sin(head)*dot(roll)"]
)toml");
  const CompiledSystem named(disc, start_options("dot(roll)=6, dot(head)=0.3"));
  const Numbers start = stated_start(assemble_start(named.checked(), 0)->model);
  CHECK(start[4] == Approx(2.4 * std::cos(0.2)).epsilon(1e-14));
  CHECK(start[5] == Approx(2.4 * std::sin(0.2)).epsilon(1e-14));
  CHECK(start[6] == 6);
  CHECK(start[7] == 0.3);
  const CompiledSystem torn(disc, start_options("dot(roll)=6, dot(x)=1"));
  const Result<CheckedModel> refused = assemble_start(torn.checked(), 0);
  REQUIRE_FALSE(refused);
  CHECK(
      refused.diagnostics.front().message ==
      "with the values of `--state`, no rates near the start meet the constraints: the residual is "
      "1.35 of `grip_1`, 0 of `grip_2`");
}

TEST_CASE("a printed state is accepted despite its rounded digits") {
  const CompiledSystem system(
      bob_on_rod, start_options("x=0.6, y=-1.1532562595, dot(x)=0.96104688289, dot(y)=0.5"));
  const Result<CheckedModel> assembled = assemble_start(system.checked(), 0);
  REQUIRE(assembled);
  const Numbers start = stated_start(assembled->model);
  CHECK(std::abs(std::hypot(start[0], start[1]) - 1.3) < 1e-15);
  CHECK(std::abs(start[0] - 0.6) < 1e-9);
  const CompiledSystem rounded(bob_on_rod, start_options("x=0.6, y=-1.153"));
  CHECK_FALSE(assemble_start(rounded.checked(), 0));
}

TEST_CASE("the work of a rod of variable length is subtracted from the energy") {
  const CompiledSystem system(plane("{ value = 1, rate = 0 }", R"toml([energy]
T = "m*(dot(x)^2 + dot(y)^2)"
V = "20*m*y"
[[constraint]]
name = "rod"
equation = "x^2 + y^2 = (1 + sin(3*t)/5)^2"
)toml"));
  const Trajectory run = evaluated(system, {.duration = 3, .tolerance = 1e-11, .row_interval = 3});
  REQUIRE(run.constraints->start.size() == 1);
  CHECK(run.constraints->start[0].name == "dot(x)");
  CHECK(run.constraints->start[0].change == Approx(0.6));
  // Reference values: an independent Runge-Kutta method of order 4 with 20000 steps.
  CHECK(run.last[1] == Approx(0.3874429055).margin(1e-7));
  CHECK(run.last[2] == Approx(-1.0107072053).margin(1e-7));
  CHECK(run.last.back() - run.rows.front().back() == Approx(-5.0374783235).margin(1e-6));
  CHECK(run.energy.name == "E - E0 - work");
  CHECK(run.energy.worst < 1e-8);
}

TEST_CASE("the work of a moving velocity constraint is subtracted too") {
  const CompiledSystem system(plane("{ value = 1, rate = 0 }", R"toml([energy]
T = "1/2*m*(dot(x)^2 + dot(y)^2)"
V = "2*x^2 + x*y + y^2"
[[constraint]]
name = "belt"
kind = "velocity"
equation = "dot(x) = 2"
)toml"));
  const Trajectory run = evaluated(system, {.duration = 2, .tolerance = 1e-11});
  CHECK(run.last[1] == Approx(5));
  CHECK(run.energy.name == "E - E0 - work");
  CHECK(run.energy.worst < 1e-8);
}

TEST_CASE("a start is assembled at the start time") {
  const CompiledSystem system(plane("{ value = 0 }", free_in_plane + R"toml([[constraint]]
name = "belt"
equation = "x = 3*t"
)toml"));
  const Trajectory run = evaluated(system, {.from = 2, .duration = 1});
  REQUIRE(run.constraints->start.size() == 2);
  CHECK(run.constraints->start[0].change == Approx(6));
  CHECK(run.constraints->start[1].change == Approx(3));
  CHECK(run.last[1] == Approx(9));
}

TEST_CASE("a momentum affected by a constraint is not listed as conserved") {
  const CompiledSystem system(plane("{ value = 1, rate = 0 }", R"toml([[coordinate]]
name = "z"
start = { value = 0, rate = 2 }
[energy]
T = "1/2*m*(dot(x)^2 + dot(y)^2 + dot(z)^2)"
[[constraint]]
name = "bore"
equation = "x^2 + y^2 = 1"
)toml"),
                              start_options("dot(y)=1"));
  const Trajectory run = evaluated(system, {.duration = 3});
  REQUIRE(run.momenta.size() == 1);
  CHECK(run.momenta.front().name == "z");
  CHECK(run.momenta.front().worst < 1e-12);
  CHECK(run.last[1] == Approx(std::cos(3)).margin(1e-6));
}

TEST_CASE("a disc that rolls and turns uniformly traces a circle") {
  const CompiledSystem system(model_text("disc", R"toml([[coordinate]]
name = "x"
unit = "m"
start = { value = 0, rate = 0.6 }
[[coordinate]]
name = "y"
unit = "m"
[[coordinate]]
name = "roll"
unit = "rad"
start = { value = 0, rate = 1.5 }
[[coordinate]]
name = "head"
unit = "rad"
start = { value = 0, rate = 0.75 }
[parameters]
m = { value = 3, unit = "kg" }
R = { value = 0.4, unit = "m" }
Ia = { value = 0.2, unit = "kg*m^2" }
J = { value = 0.1, unit = "kg*m^2" }
[energy]
T = "1/2*m*(dot(x)^2 + dot(y)^2) + 1/2*Ia*dot(roll)^2 + 1/2*J*dot(head)^2"
[[constraint]]
name = "grip"
kind = "velocity"
equation = ["dot(x) = R*cos(head)*dot(roll)", "dot(y) = R*sin(head)*dot(roll)"]
)toml"));
  const Trajectory run = evaluated(system, {.duration = 5, .tolerance = 1e-11});
  CHECK(std::abs(run.last[1] - 0.8 * std::sin(3.75)) < 1e-8);
  CHECK(std::abs(run.last[2] - 0.8 * (1 - std::cos(3.75))) < 1e-8);
  CHECK(run.energy.name == "E - E0");
  CHECK(run.energy.worst < 1e-9);
  CHECK_FALSE(run.constraints->unit);
  CHECK(run.constraints->rate_unit == "m/s");
  CHECK(run.constraints->largest.rate <= 1e-12);
  CHECK(mentions(to_text(run), "\n  rates of the constraints: residual at most "));
  REQUIRE(run.momenta.size() == 1);
  CHECK(run.momenta.front().name == "head");
}

TEST_CASE("quaternions keep their length with and without projection") {
  const CompiledSystem system(model_text("body", R"toml([[coordinate]]
name = "e"
kind = "rotation"
start = { value = [1, 0, 0, 0], rate = [0.3, 0, 1] }
[parameters]
J = 1
[[frame]]
name = "F"
parent = "world"
rotation = "e"
[[point]]
name = "P"
frame = "F"
at = ["J", "0", "0"]
[[body]]
name = "B"
frame = "F"
inertia = ["2*J", "J", "3*J"]
[[constraint]]
name = "table"
equation = "z(P) = 0"
)toml"));
  for (const bool projects : {true, false}) {
    const Trajectory run =
        evaluated(system, {.method = "rk4", .duration = 10, .step = 0.02, .projects = projects});
    double square = 0;
    for (std::size_t i = 1; i <= 4; ++i) square += run.last[i] * run.last[i];
    CHECK(std::abs(square - 1) < 2e-15);
    CHECK((run.constraints->largest.position <= 1e-12) == projects);
  }
}

TEST_CASE("a reference run meets the constraints in long double") {
  const CompiledSystem rod(bob_on_rod);
  const CompiledSystem angle(bob_by_angle);
  const Result<ReferenceRun> in_plane = run_reference(rod.checked(), rod.program(), 3);
  const Result<ReferenceRun> by_angle = run_reference(angle.checked(), angle.program(), 3);
  REQUIRE(in_plane);
  REQUIRE(by_angle);
  CHECK(std::abs(in_plane->last[0] - 1.3 * std::sin(by_angle->last[0])) < 1e-13);
  CHECK(std::abs(in_plane->last[1] + 1.3 * std::cos(by_angle->last[0])) < 1e-13);
}

TEST_CASE("E538: no pose near the start meets the constraints") {
  const CheckedModel checked = checked_model(
      plane("{ value = 1 }",
            free_in_plane + "[[constraint]]\nname = \"rod\"\nequation = \"x^2 + y^2 = -1\"\n"));
  const Result<CheckedModel> assembled = assemble_start(checked, 0);
  REQUIRE_FALSE(assembled);
  CHECK(assembled.diagnostics.front().code == Code::E538);
}

TEST_CASE("E539: symplectic methods and their compositions do not support constraints") {
  const CompiledSystem system(bob_on_rod);
  for (const std::string method : {"verlet", "midpoint"}) {
    for (const std::uint32_t order : {2U, 4U, 8U}) {
      SimulationOptions options = steps_of(method, 0.01, 1);
      options.order = order;
      const Result<Trajectory> run = system.run(options);
      REQUIRE_FALSE(run);
      const auto refused = std::ranges::find(run.diagnostics, Code::E539, &Diagnostic::code);
      REQUIRE(refused != run.diagnostics.end());
      CHECK(mentions(refused->message, "`" + method + "` does not support constraints"));
      CHECK(mentions(refused->hint, "`rk4` with `projected` after each step"));
    }
  }
}
