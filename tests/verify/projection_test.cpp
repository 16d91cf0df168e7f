// Projections: the program's exact numbers against the oracle's, for each shape of output.
#include "verify/bounds/projection.hpp"

#include <catch2/catch.hpp>

#include "verify/systems.hpp"

using namespace elgen;
using namespace elgen::test;

namespace {

/// The first field that differs.
std::string compare(const System& system, OutputKind kind, std::uint32_t user = 0) {
  const Subject subject = system.subject();
  OracleCache oracle(subject, random_state(system.model, 2));
  Random random(1);
  for (const FieldPlace& place : field_places(subject)) {
    if (place.function->kind != kind || place.function->user != user) continue;
    const BoundedRun run =
        bounded_run(system.program, *place.function, oracle.state(), rounding<double>());
    REQUIRE(run.regime == Regime::regular);
    const std::string differs = compare_projection(subject, place, run, oracle, random);
    if (!differs.empty()) return differs;
  }
  return {};
}

System oscillator() { return system_of(oscillator_model(), oscillator_program()); }

System oscillator_with(const std::string& from, const std::string& to) {
  return system_of(oscillator_model(), with(oscillator_program(), from, to));
}

}  // namespace

TEST_CASE("every output of a right program agrees") {
  const System system = cart_pole_system();
  for (const Function& function : system.program.functions) {
    INFO(function.name);
    CHECK(compare(system, function.kind, function.user).empty());
  }
}

TEST_CASE("a projection that differs in the fortieth digit differs") {
  const System system = mutated("gravity", "16 = constant 0",
                                "16 = constant 1/10000000000000000000000000000000000000000");
  CHECK(compare(system, OutputKind::gravity).find("w.x is ") == 0);
}

TEST_CASE("accelerations are judged by the equation they solve, pivots by elimination") {
  const System wrong = mutated("forward_dynamics", "25 = subtract 24 23", "25 = add 24 23");
  const auto kind = OutputKind::forward_dynamics;
  CHECK(compare(wrong, kind).find("w.(M a + bias)") == 0);
  const System pivot = mutated("forward_dynamics", "36 = divide 28 12", "36 = divide 28 10");
  CHECK(compare(pivot, kind).find("a relative pivot") == 0);
}

TEST_CASE("derivatives of accelerations are judged by the equation they solve") {
  const auto all = {OutputKind::linearization, OutputKind::inverse_dynamics_derivatives,
                    OutputKind::forward_dynamics_derivatives};
  for (const OutputKind kind : all) CHECK(compare(oscillator(), kind).empty());
  const auto forward = OutputKind::forward_dynamics_derivatives;
  const auto check = [&](const std::string& from, const std::string& to, const std::string& field) {
    const System wrong = oscillator_with(from, to);
    CHECK(compare(wrong, forward).find("w.M (X y) of " + field) == 0);
  };
  check("result by_position 1 1 = 7", "result by_position 1 1 = 6", "by_position");
  check("result by_velocity 1 1 = 9", "result by_velocity 1 1 = 7", "by_velocity");
  check("result by_input 1 1 = 5", "result by_input 1 1 = 4", "by_input");
}

TEST_CASE("the rates of positions in a linearization are compared too") {
  const auto kind = OutputKind::linearization;
  const System rates = oscillator_with("result A 2 2 = 3 4 7 9", "result A 2 2 = 4 4 7 9");
  CHECK(compare(rates, kind).find("w.X y of A is ") == 0);
  const System accelerations = oscillator_with("result A 2 2 = 3 4 7 9", "result A 2 2 = 3 4 7 7");
  CHECK(compare(accelerations, kind).find("w.M (X y) of A is ") == 0);
  const System inputs = oscillator_with("result B 2 1 = 3 5", "result B 2 1 = 5 5");
  CHECK(compare(inputs, kind).find("w.X y of B is ") == 0);
}
