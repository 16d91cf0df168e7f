// The implicit midpoint rule: its order, conserved quantities and residual.
#include <catch2/catch.hpp>
#include <cmath>

#include "program/steps/compiled_step.hpp"

namespace elgen::test {
namespace {

/// A cart on a spring carries a damped pendulum whose mass m grows with time. Terms linear in
/// dot(theta) give p = M v + b.
const std::string lifted = model_text("lifted", R"toml([[coordinate]]
name = "x"
start = { value = 0.3, rate = 1 }
armature = 0.5
[[coordinate]]
name = "theta"
start = { value = -0.2, rate = 2 }
[define]
m = "1 + t/5"
[energy]
T = """dot(x)^2 + 1/2*m*((dot(x) + dot(theta)*cos(theta))^2 + dot(theta)^2*sin(theta)^2)
  + sin(3*t)*dot(theta)"""
V = "-m*cos(theta) + 3*x^2 - x*dot(theta)"
D = "1/10*dot(theta)^2"
[[input]]
name = "u"
[[force]]
on = "x"
value = "u"
[[force]]
on = "theta"
value = "u*sin(x) - dot(x)/5"
)toml");

}  // namespace

TEST_CASE("one step of midpoint has an error of O(h^3)") {
  const cln::cl_RA h = cln::cl_RA(1) / 100;
  for (const std::string& model : {model_file("cart_pole"), model_file("double_pendulum"),
                                   model_file("charged_particle"), shaken, lifted}) {
    const StepProgram step(model, "midpoint");
    CHECK(local_order(step, generic_state(step), h) == Approx(3).margin(0.15));
  }
}

TEST_CASE("the step in C gives the same bits") {
  CompiledStep cpp({.model = lifted});
  CompiledStep c({.model = lifted, .outputs = "[emit]\nlanguage = \"c99\"\n"});
  for (int i = 0; i < 100; ++i) {
    cpp.step(0.01);
    c.step(0.01);
  }
  CHECK(c.at().q == cpp.at().q);
  CHECK(c.at().v == cpp.at().v);
  CHECK(c.residual() == cpp.residual());
}

TEST_CASE("the energy oscillates without drift in a long run") {
  CompiledStep run({.model = model_file("double_pendulum")});
  const double start = run.energy();
  double first = 0;  // largest changes in the first and in the second half of the run
  double second = 0;
  double residual = 0;
  for (int i = 0; i < 100000; ++i) {
    run.step(0.005);
    residual = std::max(residual, run.residual());
    double& worst = i < 50000 ? first : second;
    worst = std::max(worst, std::abs(run.energy() - start));
  }
  CAPTURE(start, first, second, residual);
  CHECK(first < 1e-3 * std::abs(start));
  CHECK(second < 1.2 * first);
  CHECK(residual < 1e-11);
}

TEST_CASE("the momentum of a cyclic coordinate is conserved for any number of iterations") {
  CompiledStep run({.model = model_file("cart_pole"), .more = ", iterations = 1"});
  run.at().v = {0.5, 3};
  run.at().q = {0, 1};
  const double start = run.momentum(0);
  for (int i = 0; i < 10000; ++i) run.step(0.01);
  CHECK(run.momentum(0) == Approx(start).epsilon(1e-13));
  CHECK(run.residual() > 1e-9);
}

TEST_CASE("compositions conserve momenta and return the residual of their longest substep") {
  CompiledStep run({.model = model_file("cart_pole"), .more = ", order = 4, iterations = 1"});
  run.at().v = {0.5, 3};
  run.at().q = {0, 1};
  const double start = run.momentum(0);
  for (int i = 0; i < 1000; ++i) run.step(0.01);
  CHECK(run.momentum(0) == Approx(start).epsilon(1e-13));
  CHECK(run.residual() > 1e-9);
  CompiledStep converged({.model = lifted, .more = ", order = 8"});
  converged.step(0.01);
  CHECK(converged.residual() < 1e-14);
}

TEST_CASE("residuals shrink by a factor of about h per iteration, down to rounding") {
  double last = 1;
  for (const int iterations : {1, 2, 3, 4}) {
    CompiledStep run({.model = lifted, .more = ", iterations = " + std::to_string(iterations)});
    run.step(0.01);
    CHECK(run.residual() < last / 20);
    last = run.residual();
  }
  CompiledStep run({.model = lifted});
  run.step(0.01);
  CHECK(run.residual() < 1e-15);
}

TEST_CASE("a numeric M costs nothing, and loop-invariant values are computed once") {
  const OperationCounts counts = count_operations(StepProgram(shaken, "midpoint").function());
  CHECK(counts.div == 0);
  CHECK(counts.sincos == 9 + 1);  // sin(3 (t + h/2)) is shared by all iterations
}

}  // namespace elgen::test
