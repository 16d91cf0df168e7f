// Visits: what one state says of one field, by all entries or by one projection, and whose the
// fields are.
#include "verify/bounds/visit.hpp"

#include <catch2/catch.hpp>

#include "verify/systems.hpp"

using namespace elgen;
using namespace elgen::test;

namespace {

SampledState<double> state_of(const System& system, Region region = Region::nominal) {
  auto states = sample_states<double>(system.subject(), {1, 3, false});
  states.front().region = region;
  return states.front();
}

/// What is found of the program's first field.
Finding first_finding(const System& system, Comparison comparison,
                      const SampledState<double>& state) {
  const Subject subject = system.subject();
  Visit<double> visit(subject, state, {comparison});
  Random random(1);
  return visit.look_at(field_places(subject).front(), random);
}

System alone(const std::string& body, const std::string& results) {
  return system_of(cart_pole_model(), "parameters M m l g c\ncoordinates x th\ninputs u\n" +
                                          function_text("bias", body, results));
}

const FieldPlace& place_of(const std::vector<FieldPlace>& places, const std::string& function,
                           const std::string& field) {
  for (const FieldPlace& place : places) {
    if (place.function->name == function && place.field().name == field) return place;
  }
  FAIL("no field " << function << "." << field);
  return places.front();
}

}  // namespace

TEST_CASE("a right field is exact, and its rounding is measured") {
  const System system = alone(instructions::rates, "  result 2 1 = 23 22\n");
  for (const Comparison comparison : {Comparison::entries, Comparison::projections}) {
    const Finding finding = first_finding(system, comparison, state_of(system));
    CHECK(finding.regime == Regime::regular);
    CHECK(finding.mistake.empty());
    CHECK(finding.imprecision.empty());
    REQUIRE(finding.error);
    CHECK(*finding.error <= promised_bounds);
    CHECK(finding.ulps.size() == 2);
  }
}

TEST_CASE("a wrong field is found by either comparison") {
  const System system = alone(instructions::rates, "  result 2 1 = 23 21\n");
  const SampledState<double> state = state_of(system);
  CHECK(first_finding(system, Comparison::entries, state).mistake.find("entry 2 is ") == 0);
  CHECK(first_finding(system, Comparison::projections, state).mistake.find("w.x is ") == 0);
}

TEST_CASE("only at ordinary states a value must be defined where the oracle's is") {
  const System system =
      alone(instructions::rates + "  24 = divide 22 17\n", "  result 2 1 = 23 24\n");
  const Finding ordinary = first_finding(system, Comparison::entries, state_of(system));
  CHECK(ordinary.mistake.find("is undefined, the oracle says ") != std::string::npos);
  const Finding extreme =
      first_finding(system, Comparison::entries, state_of(system, Region::extreme));
  CHECK(extreme.mistake.empty());
  CHECK(extreme.regime == Regime::undefined);
  CHECK_FALSE(extreme.error);
}

TEST_CASE("fields of an output stand one after another, with the oracle's as with the program's") {
  const System system = cart_pole_system();
  const auto places = field_places(system.subject());
  const FieldPlace& pivots = place_of(places, "forward_dynamics", "relative_pivots");
  CHECK(pivots.index == 1);
  CHECK(pivots.first == 2);
  CHECK(pivots.first_oracle == 2);
  CHECK(pivots.request.kind == OutputKind::forward_dynamics);
  CHECK(pivots.request_field == 1);
}

TEST_CASE("a field of `dynamics` is the output of its name") {
  const System system = cart_pole_system();
  const auto places = field_places(system.subject());
  const FieldPlace& bias = place_of(places, "dynamics", "bias");
  CHECK(bias.index == 1);
  CHECK(bias.first == 4);
  CHECK(bias.first_oracle == 0);
  CHECK(bias.request.kind == OutputKind::bias);
  CHECK(bias.request_field == 0);
}
