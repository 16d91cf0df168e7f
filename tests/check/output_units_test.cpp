// Units of the entries of outputs.
#include "check/judge/output_units.hpp"

#include <catch2/catch.hpp>
#include <utility>

#include "check/names/requests.hpp"
#include "check_testing.hpp"

namespace elgen::test {
namespace {

Model sliding_pendulum() {
  return checked(R"toml(format = 1
[model]
name = "a"
[[coordinate]]
name = "x"
unit = "m"
[[coordinate]]
name = "q"
unit = "rad"
[[coordinate]]
name = "free"
[[input]]
name = "u"
unit = "V"
[parameters]
m = { value = 1, unit = "kg" }
J = { value = 1, unit = "kg*m^2" }
c = 1
[energy]
T = "m*dot(x)^2 + J*dot(q)^2 + c*dot(free)^2"
[[force]]
on = "x"
value = "u*c"
)toml")
      .model;
}

std::string unit(const Model& model, const char* output, std::uint32_t row, std::uint32_t column) {
  const auto request = find_request(model, output);
  REQUIRE(request);
  const auto found = unit_of_entry(model, {request->kind, "", row, column});
  return found ? to_string(*found) : "not known";
}

TEST_CASE("units follow from those of coordinates and inputs") {
  const Model model = sliding_pendulum();
  CHECK(unit(model, "mass_matrix", 0, 0) == "kg");
  CHECK(unit(model, "mass_matrix", 0, 1) == "kg*m");
  CHECK(unit(model, "mass_matrix", 1, 1) == "kg*m^2");
  CHECK(unit(model, "coriolis_matrix", 0, 0) == "kg/s");
  CHECK(unit(model, "bias", 0, 0) == "N");
  CHECK(unit(model, "bias", 1, 0) == "J");
  CHECK(unit(model, "momentum", 0, 0) == "kg*m/s");
  CHECK(unit(model, "kinetic_energy", 0, 0) == "J");
  CHECK(unit(model, "forward_dynamics", 0, 0) == "m/s^2");
  CHECK(unit(model, "input_matrix", 0, 0) == to_string(*find_unit("N") / *find_unit("V")));
}

TEST_CASE("pivots are shares, rates of angles stay rad/s") {
  const Model model = sliding_pendulum();
  const auto pivot = unit_of_entry(model, {OutputKind::forward_dynamics, "relative_pivots", 0, 0});
  REQUIRE(pivot);
  CHECK(to_string(*pivot) == "1");
  CHECK(velocity_unit(model, model.velocities[0]) == "m/s");
  CHECK(velocity_unit(model, model.velocities[1]) == "rad/s");
  CHECK(velocity_unit(model, model.velocities[2]).empty());
}

TEST_CASE("a missing unit leaves the entry unknown") {
  const Model model = sliding_pendulum();
  CHECK(unit(model, "mass_matrix", 0, 2) == "not known");
  CHECK(unit(model, "bias", 2, 0) == "not known");
  CHECK(unit(model, "forward_dynamics", 2, 0) == "not known");
  CHECK(unit(model, "dynamics", 0, 0) == "not known");
}

}  // namespace
}  // namespace elgen::test
