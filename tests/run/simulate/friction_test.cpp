// Kinks of forces and laws, and rates held by dry friction. References: closed forms, and runs of
// DOP853 that detect the start and the end of sticking, with tolerance 1e-13.
#include <catch2/catch.hpp>
#include <cmath>

#include "run/simulate/compiled_model.hpp"
#include "run/steps/methods.hpp"
#include "support/shell.hpp"

using namespace elgen;
using namespace elgen::test;

namespace {

const std::string joint = R"toml([[coordinate]]
name = "q"
start = { value = 0, rate = 2 }
[parameters]
J = 0.05
Tcp = 0.395
Tcm = 0.435
B = 0.00148
Fc = 0.3
Fs = 0.5
vs = 0.1
s = 0.02
)toml";

const std::string coulomb = model_text("coulomb", joint + R"toml([energy]
T = "1/2*J*dot(q)^2"
D = "1/2*B*dot(q)^2"
[[force]]
on = "q"
value = "-Tcp*max(0, sign(dot(q))) - Tcm*min(0, sign(dot(q)))"
)toml");

const std::string stribeck = model_text("stribeck", joint + R"toml([energy]
T = "1/2*J*dot(q)^2"
[[force]]
on = "q"
value = "-(Fc + (Fs - Fc)*exp(-(dot(q)/vs)^2))*sign(dot(q)) - s*dot(q)"
)toml");

/// A block of 1 kg at rest, with dry friction of 1/2 N and an input.
const std::string block = model_text("block", R"toml([[coordinate]]
name = "x"
[energy]
T = "1/2*dot(x)^2"
[[force]]
on = "x"
value = "-1/2*sign(dot(x))"
[[input]]
name = "u"
on = "x"
)toml");

/// Two joints coupled by M, both with dry friction.
const std::string arm = model_text("arm", R"toml([[coordinate]]
name = "a"
start = { value = 0.3, rate = 1 }
[[coordinate]]
name = "b"
start = { value = 0.5, rate = -2 }
[energy]
T = "1/2*(3 + 2*cos(b))*dot(a)^2 + (1 + cos(b))*dot(a)*dot(b) + 1/2*dot(b)^2"
V = "2*a^2"
[[force]]
on = "a"
value = "-sign(dot(a))"
[[force]]
on = "b"
value = "-0.2*sign(dot(b))"
[[input]]
name = "u"
on = "a"
)toml");

Result<Trajectory> run(const std::string& text, const SimulationOptions& options,
                       const SceneOptions& given = {}) {
  const CompiledSystem system(text, given);
  return simulate(system.checked(), system.program(), nullptr, options);
}

/// The last row of a run without diagnostics. E - E0 - work must be below 1e-8.
std::vector<double> end_of(const std::string& text, const SimulationOptions& options,
                           const SceneOptions& given = {}) {
  const Result<Trajectory> trajectory = run(text, options, given);
  INFO(format(trajectory.diagnostics));
  REQUIRE(trajectory);
  CHECK(trajectory.diagnostics.empty());
  CHECK(trajectory->energy.worst < 1e-8);
  return trajectory->last;
}

struct Rest {
  double t = 0;
  double q = 0;
};

/// The first time at which the only rate is 0, and the position at this time.
Rest rest_of(const std::string& text) {
  const CompiledSystem compiled(text);
  SimulatedSystem system(compiled.checked(), compiled.program(), nullptr);
  const auto stepper = make_dopri5(system, {.tolerance = 1e-11, .shortest_step = 2e-12});
  Numbers state = system.start_state();
  stepper->set_interval(0, 2);
  double t = 0;
  while (t < 2 && state[1] != 0) {
    const std::optional<double> reached = stepper->step(state);
    REQUIRE(reached);
    t = *reached;
  }
  return {t, state[0]};
}

}  // namespace

TEST_CASE("two-sided Coulomb friction stops a joint and holds it") {
  // v' = -(Tcp + B v)/J
  const double t = 0.05 / 0.00148 * std::log1p(0.00148 * 2 / 0.395);
  const double q = (2 * 0.05 - 0.395 * t) / 0.00148;
  const Rest rest = rest_of(coulomb);
  CHECK(rest.t == Approx(t).margin(1e-8));
  CHECK(rest.q == Approx(q).margin(1e-8));
  CHECK(rest.t == Approx(0.25222).margin(1e-5));
  CHECK(rest.q == Approx(0.25191).margin(1e-5));
  const std::vector<double> last = end_of(coulomb, {.duration = 2});
  CHECK(last[1] == Approx(q).margin(1e-8));
  CHECK(last[2] == 0);
  const std::vector<double> back = end_of(coulomb, {.duration = 2}, start_options("dot(q)=-2"));
  CHECK(back[1] > -0.2519);
  CHECK(back[2] == 0);
}

TEST_CASE("Stribeck friction stops a joint") {
  const Rest rest = rest_of(stribeck);
  CHECK(rest.t == Approx(0.30614303618).margin(1e-8));
  CHECK(rest.q == Approx(0.30596137282).margin(1e-8));
  CHECK(end_of(stribeck, {.duration = 2})[2] == 0);
}

TEST_CASE("an input law overcomes friction as soon as it exceeds the friction") {
  // At rest until t = 1/2, then x'' = t - 1/2.
  const std::vector<double> last = end_of(block, {.duration = 2}, start_options("", "u=t"));
  CHECK(last[1] == Approx(std::pow(1.5, 3) / 6).margin(1e-8));
  CHECK(last[2] == Approx(1.5 * 1.5 / 2).margin(1e-8));
  CHECK(end_of(block, {.duration = 2}, start_options("", "u=-t"))[1] == Approx(-last[1]));
  const std::vector<double> rest =
      end_of(block, {.duration = 9}, start_options("", "u=0.49*sin(t)"));
  CHECK(rest[1] == 0);
  CHECK(rest[2] == 0);
  // Sampled inputs (`hold`) overcome the friction at a sampling time.
  const std::vector<double> held =
      end_of(block, {.duration = 2, .input_hold_time = 0.8}, start_options("", "u=t"));
  CHECK(held[2] == Approx(0.8 * 0.3 + 0.4 * 1.1).margin(1e-8));
}

TEST_CASE("friction can hold a rate at the speed of a belt, or be an input law") {
  const std::string belt = model_text("belt", R"toml([[coordinate]]
name = "x"
[energy]
T = "1/2*dot(x)^2"
[[force]]
on = "x"
value = "-2*sign(dot(x) - 1)"
[[input]]
name = "u"
on = "x"
)toml");
  CHECK(end_of(belt, {.duration = 1})[1] == Approx(0.75).margin(1e-8));
  CHECK(end_of(belt, {.duration = 1})[2] == 1);
  const std::vector<double> last =
      end_of(block, {.duration = 2}, start_options("dot(x)=1", "u=-3/2*sign(dot(x))"));
  CHECK(last[1] == Approx(0.25).margin(1e-8));
  CHECK(last[2] == 0);
}

TEST_CASE("two joints coupled by M stick one after the other, then together, and break away") {
  // a sticks at t = 0.4467, both stick at 0.5238; a breaks away at 2.7499, b at 2.9255.
  const auto at = [](double time) {
    return end_of(arm, {.duration = time, .tolerance = 1e-11}, start_options("", "u=3*sin(t)"));
  };
  const std::vector<double> both = at(2);
  CHECK(both[1] == Approx(0.536318450805).margin(1e-8));
  CHECK(both[2] == Approx(0.021942438676).margin(1e-8));
  CHECK(both[3] == 0);
  CHECK(both[4] == 0);
  const std::vector<double> last = at(8);
  CHECK(last[1] == Approx(1.242609769721).margin(1e-8));
  CHECK(last[2] == Approx(-1.908630554377).margin(1e-8));
  CHECK(last[3] == Approx(0.539245416349).margin(1e-8));
  CHECK(last[4] == Approx(-0.299408925443).margin(1e-8));
}

TEST_CASE("rates that reach their kinks at the same time are held together") {
  const std::vector<double> last = end_of(model_text("twins", R"toml([[coordinate]]
name = "a"
start = { value = 0, rate = 1 }
[[coordinate]]
name = "b"
start = { value = 0, rate = 1 }
[energy]
T = "dot(a)^2 + dot(a)*dot(b) + dot(b)^2"
[[force]]
on = "a"
value = "-sign(dot(a))"
[[force]]
on = "b"
value = "-sign(dot(b))"
)toml"),
                                          {.duration = 5});
  CHECK(last[1] == Approx(1.5).margin(1e-8));
  CHECK(last[2] == Approx(1.5).margin(1e-8));
  CHECK(last[3] == 0);
  CHECK(last[4] == 0);
}

TEST_CASE("friction holds a rate that a constraint couples to another rate") {
  const std::vector<double> last = end_of(model_text("tied", R"toml([[coordinate]]
name = "x"
start = { value = 0, rate = 1 }
[[coordinate]]
name = "y"
start = { value = 0, rate = 1 }
[energy]
T = "1/2*(dot(x)^2 + dot(y)^2)"
[[constraint]]
name = "wall"
equation = "x = y"
[[force]]
on = "x"
value = "-sign(dot(x))"
)toml"),
                                          {.duration = 4});
  CHECK(last[1] == Approx(1).margin(1e-8));
  CHECK(last[2] == Approx(1).margin(1e-8));
  CHECK(last[3] == 0);
  CHECK(last[4] == Approx(0).margin(1e-12));
}

TEST_CASE("crossing a kink neither ends a run nor costs accuracy") {
  const std::string wall = model_text("wall", R"toml([[coordinate]]
name = "x"
start = { value = 1, rate = -1 }
[energy]
T = "1/2*dot(x)^2"
[[force]]
on = "x"
value = "1000*max(0, -x)"
)toml");
  // The wall acts as a spring: x returns to 0 after half of the period 2 pi/sqrt(1000).
  const double back = 1 + M_PI / std::sqrt(1000.0);
  CHECK(end_of(wall, {.duration = 3})[1] == Approx(3 - back).margin(1e-7));
  const std::string jump = model_text("jump", R"toml([[coordinate]]
name = "x"
start = { value = 1, rate = 0 }
[energy]
T = "1/2*dot(x)^2"
[[force]]
on = "x"
value = "-sign(x)"
)toml");
  // The period is 4 sqrt(2).
  const std::vector<double> last = end_of(jump, {.duration = 8 * std::sqrt(2)});
  CHECK(last[1] == Approx(1).margin(1e-7));
  CHECK(last[2] == Approx(0).margin(1e-7));
}

TEST_CASE("kinks are crossed at t = 1e7, where adjacent doubles are 2e-9 apart") {
  const SceneOptions given = start_options("x=0.47", "u=-30*x");
  const double right = end_of(block, {.duration = 3}, given)[1];
  const Result<Trajectory> far = run(block, {.from = 1e7, .duration = 3}, given);
  INFO(format(far.diagnostics));
  REQUIRE(far);
  CHECK(far->last[1] == Approx(right).margin(1e-6));
}

TEST_CASE("a motion that slides along another kind of kink ends, with a message and a hint") {
  const std::string free = model_text("loose", R"toml([[coordinate]]
name = "x"
start = { value = 1, rate = 0 }
[[coordinate]]
name = "y"
[energy]
T = "1/2*(dot(x)^2 + dot(y)^2)"
[[input]]
name = "u"
on = "x"
)toml");
  const auto slides = [](const std::string& text, const std::string& law, const std::string& kink) {
    const Result<Trajectory> ended = run(text, {.duration = 2}, start_options("", "u=" + law));
    REQUIRE_FALSE(ended);
    const Diagnostic& end = ended.diagnostics.front();
    CHECK(end.code == Code::E624);
    CHECK(mentions(end.message, "the motion slides along the kink of `" + kink + "` after t = "));
    CHECK(mentions(end.hint, "tanh(x/width); `--method rk4 --step` continues over the kink"));
  };
  slides(free, "-10*sign(x + dot(x))", "sign(x + dot(x))");
  // The start is on the kink itself.
  slides(model_file("cart_pole"), "-10*sign(x + dot(x))", "sign(x + dot(x))");
  // A force on y with a kink in the rate of x.
  const std::string drag = "[[force]]\non = \"y\"\nvalue = \"-sign(dot(x) + dot(y) - 1)\"\n";
  slides(free + drag, "0", "sign(dot(x) + dot(y) - 1)");
}

TEST_CASE("constant steps creep through friction and report their energy loss") {
  const Result<Trajectory> creeps =
      run(coulomb, steps_of("rk4", 0.01, 40), start_options("dot(q)=2"));
  REQUIRE(creeps);
  REQUIRE(creeps.diagnostics.size() == 1);
  CHECK(creeps.diagnostics.front().code == Code::E648);
  CHECK(run(coulomb, {.duration = 2})->steps < 300);
}
