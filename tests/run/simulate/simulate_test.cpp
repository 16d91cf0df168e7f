// Whole runs: trajectories with external references in 30 digits, rows, and sampled inputs.
#include "elgen/simulate.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

#include "run/simulate/compiled_model.hpp"
#include "support/shell.hpp"

using namespace elgen;
using namespace elgen::test;

namespace {

/// The message that refuses a start on a sphere; `singular` is a line of the coordinate theta.
std::string start_refusal(const std::string& start, const std::string& singular) {
  const CompiledSystem compiled(model_text("sphere", R"toml([[coordinate]]
name = "theta"
)toml" + singular + R"toml([[coordinate]]
name = "phi"
[energy]
T = "1/2*dot(theta)^2 + 1/2*sin(theta)^2*dot(phi)^2"
)toml"),
                                start_options(start));
  const Diagnostics refused = compiled.run({.duration = 1e-3}).diagnostics;
  return refused.empty() ? "" : refused.front().message;
}

const std::string stated = "singular = \"sin(theta)\"\n";

}  // namespace

TEST_CASE("reference runs of fourteen systems end at their known states") {
  const auto cases = nlohmann::json::parse(
      read_text(std::string(ELGEN_SOURCE_DIR) + "/tests/run/simulate/trajectories.json"));
  REQUIRE(cases.size() == 14);
  // The largest sensitivity up to time t amplifies the error of each step. The errors of at most
  // 100 + t steps of tolerance 1e-15 add up. Runs with 1e-18 make more steps with smaller errors.
  const double tolerance = 3e-15;
  for (const auto& one : cases) {
    const CompiledSystem compiled(one["model"], start_options(one["start"]));
    double sensitivity = 1;
    for (const auto& known : one["at"]) {
      INFO(one["id"] << " at " << known["t"]);
      sensitivity = std::max(sensitivity, known["sensitivity"].get<double>());
      const Result<ReferenceRun> run =
          run_reference(compiled.checked(), compiled.program(), known["t"].get<double>());
      REQUIRE(run);
      double error = 0;
      double rougher = 0;
      for (std::size_t i = 0; i < known["state"].size(); ++i) {
        const auto truth = known["state"][i].get<double>();
        error = std::max(error, std::abs(run->last[i] - truth));
        rougher = std::max(rougher, std::abs(run->rough_last[i] - run->last[i]));
      }
      const double steps = 100 + known["t"].get<double>();
      CHECK(error < steps * (tolerance + std::numeric_limits<double>::epsilon()) * sensitivity);
      // Both runs start at the start in double, the known states at the start as typed.
      const double rounding = std::numeric_limits<double>::epsilon() * sensitivity;
      CHECK(error <= 4 * rougher + rounding + 1e-14);
    }
  }
}

TEST_CASE("a reference run has a larger tolerance if inputs have laws or if it takes many steps") {
  const auto tolerance_of = [](const std::string& law, double time) {
    const CompiledSystem compiled(model_text("mass", R"toml([[coordinate]]
name = "x"
start = { value = 1, rate = 0 }
[energy]
T = "1/2*dot(x)^2"
V = "1/2*x^2"
[[input]]
name = "u"
on = "x"
)toml"),
                                  start_options("", law));
    const Result<ReferenceRun> run = run_reference(compiled.checked(), compiled.program(), time);
    REQUIRE(run);
    return run->tolerance;
  };
  CHECK(tolerance_of("", 10) == 1e-18);
  CHECK(tolerance_of("u=-x", 10) == 1e-15);
  CHECK(tolerance_of("", 2000) == 1e-15);
}

TEST_CASE("rows are at their times, including the start and the end") {
  const CompiledSystem pendulum(read_model("free_pendulum"));
  const Trajectory run = pendulum.trajectory(
      {.method = "rk4", .from = 2, .duration = 1, .step = 0.04, .row_interval = 0.3});
  REQUIRE(run.rows.size() == 5);
  for (std::size_t i = 0; i < 4; ++i) CHECK(run.rows[i][0] == 2 + 0.3 * static_cast<double>(i));
  CHECK(run.rows.back()[0] == 3);
  CHECK(run.rows.back() == run.last);
  // Eight steps between rows 0.3 apart, three steps in the last interval of 0.1.
  CHECK(run.steps == 3 * 8 + 3);
  CHECK(run.columns.size() == 4);
  CHECK(run.columns[2].name == "dot(q)");
  CHECK(run.columns[3].unit.empty());
  CHECK(pendulum.trajectory(steps_of("rk4", 0.1, 1)).rows.empty());
}

TEST_CASE("requested columns have panels, and every row contains the position of a point") {
  const CompiledSystem bob(model_text("bob", R"toml([[coordinate]]
name = "q"
start = { value = 1, rate = 0 }
[[point]]
name = "bob"
at = ["2*sin(q)", "-2*cos(q)"]
mass = "1"
[gravity]
vector = ["0", "-9"]
)toml"));
  const auto run = [&bob](std::vector<std::string> show, const std::string& path) {
    SimulationOptions options = steps_of("rk4", 0.1, 0.2);
    options.row_interval = 0.1;
    options.panel_columns = std::move(show);
    options.path = path;
    return simulate(bob.checked(), bob.program(), nullptr, options);
  };
  const Result<Trajectory> shown = run({"q", " dot(q)"}, "");
  REQUIRE(shown);
  CHECK(shown->columns[1].panel == "q");
  CHECK(shown->columns[2].panel == "q\u0307");
  CHECK(mentions(to_svg(*shown), ">q\u0307<"));
  const Result<Trajectory> drawn = run({}, "bob");
  REQUIRE(drawn);
  CHECK(drawn->columns[2].panel.empty());
  REQUIRE(drawn->columns.size() == 6);
  CHECK(drawn->columns[3].name == "x(bob)");
  for (const auto& row : drawn->rows) {
    CHECK(row[3] == Approx(2 * std::sin(row[1])));
    CHECK(row[4] == Approx(-2 * std::cos(row[1])));
  }
  const Diagnostics unknown = run({"dot(p)", "lambda_rod"}, "bobb").diagnostics;
  REQUIRE(unknown.size() == 3);
  CHECK(unknown[0].code == Code::E201);
  CHECK(unknown[0].message == "unknown column `dot(p)`");
  CHECK(unknown[0].hint == "did you mean `dot(q)`?");
  CHECK(unknown[1].message == "unknown column `lambda_rod`");
  CHECK(unknown[1].hint.starts_with("there are: t, q, dot(q), "));
  CHECK(unknown[2].message == "unknown point `bobb`");
  CHECK(unknown[2].hint == "did you mean `bob`?");
}

TEST_CASE("a sampled input is constant from one sampling time to the next") {
  // x'' = -1 until 1/4, then -31/32.
  const CompiledSystem held(read_model("spring"), start_options("", "u=-x", "k=0"));
  SimulationOptions options{.method = "rk4", .duration = 0.5, .step = 0.25};
  options.input_hold_time = 0.25;
  const Trajectory run = held.trajectory(options);
  CHECK(run.last[1] == Approx(0.8759765625).epsilon(1e-14));
  CHECK(run.last[2] == Approx(-0.25 - 0.96875 / 4).epsilon(1e-14));
}

TEST_CASE("if E0 = 0, drifts are relative to |T| + |V|") {
  const CompiledSystem balanced(model_text("balanced", R"toml([[coordinate]]
name = "x"
start = { value = 1, rate = 2 }
[energy]
T = "1/2*dot(x)^2"
V = "-2*x^2"
)toml"));
  const Trajectory run = balanced.trajectory(steps_of("verlet", 0.01, 2));
  CHECK(run.energy.scale > 100);
  CHECK(run.energy.worst < 1e-3);
}

TEST_CASE("a trajectory that becomes infinite reports the time and the state") {
  const CompiledSystem runaway(model_text("runaway", R"toml([[coordinate]]
name = "x"
start = { value = 1, rate = 0 }
[energy]
T = "1/2*dot(x)^2"
V = "-x^4"
)toml"));
  const Result<Trajectory> run = runaway.run(steps_of("rk4", 0.01, 10));
  REQUIRE_FALSE(run);
  const Diagnostic& ended = run.diagnostics.front();
  CHECK(ended.code == Code::E624);
  CHECK(ended.message.starts_with("the numbers are no longer finite after t = 0.9"));
  CHECK(mentions(ended.message, "where x = "));
}

TEST_CASE("locks and fixed parameters of a scene apply to its runs") {
  SceneOptions options = start_options("x=1/2");
  options.fixed = {make_source("command line", "k=9")};
  const CompiledSystem fixed(read_model("spring"), options);
  const Trajectory run = fixed.trajectory({.duration = M_PI, .tolerance = 1e-12});
  CHECK(run.last[1] == Approx(-0.5));
}

TEST_CASE("the chart is singular if a declared factor is zero, up to the rounding of pi") {
  const std::string broken = "the chart of `theta` breaks at the start, where `sin(theta)` is zero";
  CHECK(start_refusal("theta=0", stated) == broken);
  CHECK(start_refusal("theta=pi", stated) == broken);
  CHECK(start_refusal("theta=1e-7", stated).empty());
}

TEST_CASE("if M is singular, the pivot is named") {
  CHECK(start_refusal("theta=1e-9", "").empty());
  const std::string broken = start_refusal("theta=0", "");
  CHECK(broken.starts_with("M is singular at the start: the relative pivot of `dot(phi)` is "));
}

TEST_CASE("a run that continues in compiled functions has the bits of an interpreted run") {
  const CompiledSystem arm(model_file("two_link_arm"));
  SimulationOptions options{.duration = 5, .row_interval = 0.5};
  const Result<Trajectory> interpreted = simulate(arm.checked(), arm.program(), nullptr, options);
  std::size_t compilations = 0;
  options.compile = [&]() -> Result<const CompiledModel*> {
    ++compilations;
    return &arm.functions();
  };
  options.most_interpreted = 10'000;
  const Result<Trajectory> changed = simulate(arm.checked(), arm.program(), nullptr, options);
  REQUIRE(interpreted);
  REQUIRE(changed);
  CHECK(compilations == 1);
  CHECK(interpreted->timed_code == "in the evaluator");
  CHECK(changed->timed_code == "of the emitted C++");
  CHECK(changed->rows == interpreted->rows);
  options.compile = []() -> Result<const CompiledModel*> { return nullptr; };
  const Result<Trajectory> without = simulate(arm.checked(), arm.program(), nullptr, options);
  REQUIRE(without);
  CHECK(without->timed_code == "in the evaluator");
  CHECK(without->rows == interpreted->rows);
  options.compile = []() -> Result<const CompiledModel*> {
    return Diagnostics{{Code::E909, {}, "the compiler exceeds the limit", ""}};
  };
  CHECK(simulate(arm.checked(), arm.program(), nullptr, options).diagnostics.front().code ==
        Code::E909);
}
