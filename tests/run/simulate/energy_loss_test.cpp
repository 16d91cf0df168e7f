// Energy lost by runs with constant steps: messages, exit code 1, and runs without loss.
#include <catch2/catch.hpp>
#include <cmath>

#include "run/simulate/compiled_model.hpp"
#include "support/shell.hpp"

using namespace elgen;
using namespace elgen::test;

namespace {

/// A planar orbit that passes its centre at a distance of 5e-5.
std::string orbit(const std::string& energy) {
  return model_text("orbit", R"toml([[coordinate]]
name = "x"
start = { value = 1, rate = 0 }
[[coordinate]]
name = "y"
start = { value = 0, rate = 0.01 }
[energy]
)toml" + energy);
}

const std::string kinetic = "T = \"1/2*(dot(x)^2 + dot(y)^2)\"\n";

Result<Trajectory> by_rk4(const std::string& text, double step, double time,
                          const SceneOptions& given = {}) {
  const CompiledSystem system(text, given);
  return simulate(system.checked(), system.program(), nullptr, steps_of("rk4", step, time));
}

/// The message of the only diagnostic, an E648; "" if there is none.
std::string loss_message(const Result<Trajectory>& run) {
  REQUIRE(run);
  if (run.diagnostics.empty()) return "";
  CHECK(run.diagnostics.size() == 1);
  CHECK(run.diagnostics.front().code == Code::E648);
  return run.diagnostics.front().message;
}

}  // namespace

TEST_CASE("an orbit ejected from its well by large steps loses energy, for any offset of V") {
  for (const std::string offset : {"", " + 1000000", " - 1000000"}) {
    INFO(offset);
    const auto run = by_rk4(orbit(kinetic + "V = \"-1/sqrt(x^2 + y^2)" + offset + "\"\n"), 0.01, 5);
    CHECK(mentions(loss_message(run),
                   "E - E0 deviates by up to 1.9e+02, 74.8 % of the largest |T| plus the "));
    CHECK(run->loses_energy);
    CHECK(run->last.front() == 5);
  }
}

TEST_CASE("the energy of a Lagrangian given as L is scaled by |v.p| + |L|") {
  const auto run =
      by_rk4(orbit("L = \"1/2*(dot(x)^2 + dot(y)^2) + 1/sqrt(x^2 + y^2)\"\n"), 0.01, 5);
  CHECK(mentions(loss_message(run), " of the largest |v.p| + |L|, "));
  CHECK(run->loses_energy);
}

TEST_CASE("short steps lose nothing, and neither does a system at rest") {
  const std::string far = orbit(kinetic + "V = \"-1/sqrt(x^2 + y^2)\"\n");
  const auto kept = by_rk4(far, 0.01, 1);
  CHECK(loss_message(kept).empty());
  CHECK_FALSE(kept->loses_energy);
  const auto still = by_rk4(orbit(kinetic), 0.01, 1, start_options("dot(y)=0"));
  CHECK(loss_message(still).empty());
  // The rounding error of V exceeds T here.
  const std::string top = model_text("top", R"toml([[coordinate]]
name = "q"
start = { value = "pi", rate = 0 }
[energy]
T = "1/2*dot(q)^2"
V = "-7.3*cos(q) + 1/3"
)toml");
  CHECK(loss_message(by_rk4(top, 0.01, 2)).empty());
}

TEST_CASE("the work of forces and inputs is not a loss") {
  CHECK(
      loss_message(by_rk4(read_model("spring"), 0.01, 5, start_options("", "u=-dot(x)"))).empty());
}

TEST_CASE("a loss between 1 and 10 % is only reported") {
  const auto run = by_rk4(read_model("spring"), 0.4, 10);
  CHECK(mentions(loss_message(run), " % of the largest |T| plus the range of V, "));
  CHECK_FALSE(run->loses_energy);
}

TEST_CASE("the energy of verlet and midpoint may oscillate but not drift") {
  const auto run = [](const std::string& method, double step, double time) {
    const CompiledSystem spring(read_model("spring"));
    return spring.run(steps_of(method, step, time));
  };
  const auto swings = run("verlet", 0.4, 1000);
  CHECK(loss_message(swings).empty());
  CHECK(swings->energy.worst > 0.15);
  CHECK_FALSE(swings->loses_energy);
  CHECK(loss_message(run("midpoint", 0.1, 20)).empty());
  const CompiledSystem thrown(orbit(kinetic + "V = \"-1/sqrt(x^2 + y^2)\"\n"));
  const auto lost = thrown.run(steps_of("verlet", 0.01, 5));
  CHECK(mentions(loss_message(lost), "E - E0 drifts by "));
  CHECK(lost->loses_energy);
}

TEST_CASE("a changed entry of `conserved` is reported, but the run does not fail") {
  const std::string text = read_model("spring") + "[[expect]]\nconserved = [\"E\"]\n";
  CHECK(loss_message(by_rk4(text, 0.01, 5)).empty());
  const auto run = by_rk4(text, 0.01, 5, start_options("", "u=1"));
  CHECK(mentions(loss_message(run), "`E` of `conserved` deviates by up to "));
  CHECK_FALSE(run->loses_energy);
  // Both terms of the conserved quantity are 0, because y and dot(y) stay 0.
  const std::string turn = orbit(kinetic + "V = \"-1/sqrt(x^2 + y^2)\"\n") +
                           "[[expect]]\nconserved = [\"x*dot(y) - y*dot(x)\"]\n";
  CHECK(loss_message(by_rk4(turn, 0.001, 0.5, start_options("dot(y)=0"))).empty());
}

TEST_CASE("runs with adaptive steps are judged by their tolerance") {
  const CompiledSystem system(orbit(kinetic + "V = \"-1/sqrt(x^2 + y^2)\"\n"));
  const auto run = system.run({.duration = 5});
  CHECK(loss_message(run).empty());
  CHECK_FALSE(run->loses_energy);
}
