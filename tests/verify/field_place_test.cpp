// Places of fields: whose they are and what the oracle is asked for.
#include "verify/bounds/field_place.hpp"

#include <catch2/catch.hpp>

#include "verify/systems.hpp"

using namespace elgen;
using namespace elgen::test;

namespace {

const FieldPlace& place_of(const std::vector<FieldPlace>& places, const std::string& function,
                           const std::string& field) {
  for (const FieldPlace& place : places) {
    if (place.function->name == function && place.field().name == field) return place;
  }
  FAIL("no field " << function << "." << field);
  return places.front();
}

}  // namespace

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
