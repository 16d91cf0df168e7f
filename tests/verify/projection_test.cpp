// Projections: the program's exact numbers against the oracle's, for each shape of output.
#include "verify/projection.hpp"

#include <catch2/catch.hpp>

#include "verify/systems.hpp"

using namespace elgen;
using namespace elgen::test;

namespace {

std::string compare(const System& system, const Function& function) {
  const Subject subject = system.subject();
  OracleCache oracle(subject, random_state(system.model, 2));
  Random random(1);
  const BoundedRun run = bounded_run<double>(system.program, function, oracle.state());
  REQUIRE(run.regime == Regime::regular);
  return compare_projection(subject, {function, run}, oracle, random);
}

}  // namespace

TEST_CASE("every output of a right program agrees") {
  const System system = cart_pole_system();
  for (const Function& function : system.program.functions) {
    if (function.kind == OutputKind::dynamics) continue;
    INFO(function.name);
    CHECK(compare(system, function).empty());
  }
}

TEST_CASE("a projection that differs in the fortieth digit differs") {
  const System system = mutated("gravity", "16 = constant 0",
                                "16 = constant 1/10000000000000000000000000000000000000000");
  CHECK(compare(system, *find_function(system.program, OutputKind::gravity)).find("w.x is ") == 0);
}

TEST_CASE("accelerations are judged by the equation they solve, pivots by elimination") {
  const System wrong = mutated("forward_dynamics", "25 = subtract 24 23", "25 = add 24 23");
  const auto kind = OutputKind::forward_dynamics;
  CHECK(compare(wrong, *find_function(wrong.program, kind)).find("w.(M a + bias)") == 0);
  const System pivot = mutated("forward_dynamics", "36 = divide 28 12", "36 = divide 28 10");
  CHECK(compare(pivot, *find_function(pivot.program, kind)).find("a relative pivot") == 0);
}
