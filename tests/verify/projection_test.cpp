// Compares projections of the program's exact numbers with projections of the oracle's numbers.
// self_check_test covers every output.
#include "verify/bounds/projection.hpp"

#include <catch2/catch.hpp>

#include "verify/systems.hpp"

using namespace elgen;
using namespace elgen::test;

namespace {

/// The message for the first field that differs, "" if all fields agree.
std::string compare(const System& system, OutputKind kind) {
  const SystemUnderTest subject = system.subject();
  OracleCache oracle(subject, random_state(system.model, 2));
  Sampler draw(1);
  for (const ComparedField& place : field_places(subject)) {
    if (place.function->kind != kind) continue;
    const ExactRun run =
        run_exactly(system.program, *place.function, oracle.state(), rounding_constants<double>());
    REQUIRE(run.regime == Regime::regular);
    const auto differs = compare_projection(subject, place, run, oracle, draw);
    REQUIRE(differs);
    if (!differs->text.empty()) return differs->text;
  }
  return {};
}

}  // namespace

TEST_CASE("a projection that differs in the fortieth digit differs") {
  const System system = with_mistake("gravity", "16 = constant 0",
                                     "16 = constant 1/10000000000000000000000000000000000000000");
  CHECK(compare(system, OutputKind::gravity).find("w.x is ") == 0);
}

TEST_CASE("accelerations are tested by the equation that they solve, pivots by elimination") {
  const System wrong = with_mistake("forward_dynamics", "25 = subtract 24 23", "25 = add 24 23");
  const auto kind = OutputKind::forward_dynamics;
  CHECK(compare(wrong, kind).find("w.(M a + bias)") == 0);
  const System pivot = with_mistake("forward_dynamics", "36 = divide 28 12", "36 = divide 28 10");
  CHECK(compare(pivot, kind).find("a relative pivot") == 0);
}
