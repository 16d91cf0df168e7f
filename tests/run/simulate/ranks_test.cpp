// Loss of rank of M or of the constraints: messages at given states, and runs into such a state
// with all kinds of steps.
#include "run/simulate/ranks.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <string>
#include <vector>

#include "run/simulate/compiled_model.hpp"
#include "support/shell.hpp"

using namespace elgen;
using namespace elgen::test;

namespace {

/// A crank as long as its rod; if both are upright, the guide constrains neither.
const std::string crank = model_text("crank", R"toml([[coordinate]]
name = "a"
start = { value = 0.5, rate = 2 }
[[coordinate]]
name = "b"
start = { value = -0.5, rate = -2 }
[parameters]
J = 2
[energy]
T = "1/2*J*dot(a)^2 + 1/2*dot(b)^2"
V = "sin(a)/3 - cos(2*b)"
[[constraint]]
name = "guide"
equation = "sin(a) + sin(b) = 0"
)toml");

/// T = 1/2 m (dx/dt + dy/dt)^2 + 1/2 m `squares` (dy/dt)^2
std::string two_rates(const std::string& squares) {
  return model_text("rates", R"toml([[coordinate]]
name = "x"
[[coordinate]]
name = "y"
start = { value = 1, rate = -1 }
[parameters]
m = 1
[energy]
T = "1/2*m*(dot(x) + dot(y))^2 + 1/2*m*()toml" +
                                 squares + ")*dot(y)^2\"\n");
}

Result<Trajectory> in_evaluator(const CompiledSystem& system, const SimulationOptions& options) {
  return simulate(system.checked(), system.program(), nullptr, options);
}

/// The message for the last of `states`. Fails if an earlier state has a message.
std::string message_of(const CompiledSystem& system, const std::vector<Numbers>& states) {
  SimulatedSystem evaluator(system.checked(), system.program(), nullptr);
  RankWatch ranks(evaluator, "go elsewhere");
  Diagnostics said;
  for (const Numbers& state : states) {
    REQUIRE(said.empty());
    said = ranks.check_ranks(state, 7);
  }
  if (said.empty()) return "";
  CHECK(said.front().code == Code::E624);
  CHECK(said.front().hint == "go elsewhere");
  return said.front().message;
}

}  // namespace

TEST_CASE("a pivot that becomes small or changes its sign is reported with its velocity") {
  const CompiledSystem shrinking(two_rates("y^2"));
  CHECK(message_of(shrinking, {{0, 1, 0, 0}, {0, 1e-3, 0, 0}}).empty());
  CHECK(message_of(shrinking, {{0, 1, 0, 0}, {0, 1e-5, 3, -2}}) ==
        "rank is nearly lost, because the pivot of `dot(y)` in M is 2.0e-10 of its largest value, "
        "at t = 7, where x = 0, y = 1e-05, dot(x) = 3, dot(y) = -2");
  const CompiledSystem turning(two_rates("y"));
  CHECK(message_of(turning, {{0, 1, 0, 0}, {0, -0.5, 0, 0}}) ==
        "rank is lost, because the pivot of `dot(y)` in M changes its sign, before t = 7, where x "
        "= 0, y = -0.5, dot(x) = 0, dot(y) = 0");
}

TEST_CASE("a constraint row that shrinks or reverses is reported with its constraint") {
  const CompiledSystem system(crank);
  const auto at = [](double a) { return Numbers{a, -a, 1, -1}; };
  CHECK(message_of(system, {at(0.5), at(1.5)}).empty());
  CHECK(mentions(
      message_of(system, {at(0.5), at(M_PI / 2 - 1e-5)}),
      "rank is nearly lost, because the pivot of `guide` in A is 1.3e-10 of its largest value"));
  CHECK(mentions(message_of(system, {at(0.5), at(1.5), at(1.7)}),
                 "rank is lost, because the row of `guide` in A reverses, before t = 7"));
}

TEST_CASE("small inertias and rows that rotate with the motion are no loss of rank") {
  const CompiledSystem orbit(model_text("orbit", R"toml([[coordinate]]
name = "r"
start = { value = 1, rate = 0 }
[[coordinate]]
name = "phi"
[energy]
T = "1/2*dot(r)^2 + 1/2*r^2*dot(phi)^2"
V = "-1/r"
)toml"));
  CHECK(message_of(orbit, {{1, 0, 0, 1}, {1e-6, 0, 0, 1}}).empty());
  const CompiledSystem rod(model_text("rod", R"toml([[coordinate]]
name = "x"
start = { value = 1, rate = 0 }
[[coordinate]]
name = "y"
[energy]
T = "1/2*dot(x)^2 + 1/2*dot(y)^2"
[[constraint]]
name = "rod"
equation = "x^2 + y^2 = 1"
)toml"));
  CHECK(message_of(rod, {{1, 0, 0, 1}, {-0.3, std::sqrt(0.91), 1, 0}, {-1, 0, 0, 0}}).empty());
}

TEST_CASE("runs into a singular state stop for every tolerance and step") {
  const CompiledSystem bars(model_file("five_bar"));
  const CompiledSystem with_guide(crank);
  const auto stops = [](const CompiledSystem& system, const SimulationOptions& options,
                        const std::string& constraint) {
    INFO(options.tolerance.value_or(0) << " " << options.step.value_or(0));
    const Result<Trajectory> run = in_evaluator(system, options);
    REQUIRE_FALSE(run);
    const Diagnostic& stop = run.diagnostics.front();
    CHECK(stop.code == Code::E624);
    CHECK(mentions(stop.message, "of `" + constraint + "` in A "));
    CHECK(mentions(stop.hint, "`--through singular`"));
  };
  for (const double tolerance : {1e-3, 1e-6, 1e-7, 1e-9, 1e-12}) {
    stops(bars, {.duration = 0.3, .tolerance = tolerance}, "loop_x");
    stops(with_guide, {.duration = 1, .tolerance = tolerance}, "guide");
  }
  for (const double step : {1e-2, 1e-3}) {
    stops(bars, steps_of("rk4", step, 0.3), "loop_x");
    stops(with_guide, steps_of("dopri5", step, 1), "guide");
  }
}

TEST_CASE("runs with constant steps pass a singular state on request") {
  SimulationOptions options = steps_of("rk4", 1e-4, 0.3);
  options.continues_at_singularity = true;
  const Result<Trajectory> run = in_evaluator(CompiledSystem(model_file("five_bar")), options);
  REQUIRE(run);
  CHECK(run->last[1] == Approx(3.385315865).margin(1e-9));
  CHECK(run->energy.worst < 1e-11);
}

TEST_CASE("a reference run never passes a singular state") {
  const CompiledSystem bars(model_file("five_bar"));
  const Result<ReferenceRun> through = run_reference(bars.checked(), bars.program(), 0.3);
  REQUIRE_FALSE(through);
  CHECK(through.diagnostics.front().code == Code::E624);
  CHECK(mentions(through.diagnostics.front().message, " of `loop_x` in A "));
  CHECK(run_reference(bars.checked(), bars.program(), 0.2));
}

TEST_CASE("if a step becomes too short, the small pivot is named") {
  const CompiledSystem system(model_text("lever", R"toml([[coordinate]]
name = "x"
start = { value = 1, rate = -1 }
[energy]
T = "1/2*(1 + cos(x))*dot(x)^2"
)toml"));
  const Result<Trajectory> run = in_evaluator(system, {.duration = 10});
  REQUIRE_FALSE(run);
  const std::string& message = run.diagnostics.front().message;
  CHECK(mentions(message, "a step that is too short after t = 3.37159, where x = -3.141"));
  CHECK(mentions(message, ": the pivot of `dot(x)` in M is "));
}

TEST_CASE("an energy loss beyond the tolerance is a warning, a loss within it is not") {
  const std::string start = R"toml([[coordinate]]
name = "x"
start = { value = 0, rate = -1 }
[energy]
T = "1/2*dot(x)^2"
)toml";
  // One step from the top of the hill goes beyond its foot.
  const CompiledSystem hill(model_text("hill", start + "V = \"exp(-1e6*x^2)\"\n"));
  const CompiledSystem wall(model_text("wall", start + "V = \"exp(-5*x)\"\n"));
  for (const double tolerance : {1e-6, 1e-9, 1e-12}) {
    const Result<Trajectory> lost = in_evaluator(hill, {.duration = 2, .tolerance = tolerance});
    REQUIRE(lost);
    REQUIRE(lost.diagnostics.size() == 1);
    CHECK(lost.diagnostics.front().code == Code::E648);
    CHECK(mentions(lost.diagnostics.front().message, "E - E0 is -1.0e+00 at t = 0.02, beyond "));
    const Result<Trajectory> kept = in_evaluator(wall, {.duration = 2, .tolerance = tolerance});
    REQUIRE(kept);
    CHECK(kept.diagnostics.empty());
  }
  CHECK(in_evaluator(hill, steps_of("rk4", 1e-2, 2)).diagnostics.front().message ==
        "E - E0 deviates by up to 1.0e+00, 66.7 % of the largest |T| plus the range of V, 1.5");
}
