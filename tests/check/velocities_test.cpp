// Coordinates and the velocities that move them.
#include <catch2/catch.hpp>

#include "elgen/leaf_names.hpp"
#include "elgen/model.hpp"

namespace elgen::test {

TEST_CASE("a coordinate comes with its rate") {
  Model model;
  Coordinate plain;
  plain.name = "s[2]";
  plain.identifier = "s_2";
  plain.unit = find_unit("m");
  plain.unit_text = "m";
  CHECK(append_coordinate(model, {}) == 0);
  CHECK(append_coordinate(model, plain) == 1);
  REQUIRE(model.velocities.size() == 2);
  CHECK(model.coordinates[1].velocity == 1);
  const Velocity& rate = model.velocities[1];
  CHECK(rate.name == "s[2]");
  CHECK(rate.identifier == "s_2");
  CHECK(rate.coordinate == 1);
  CHECK(rate.unit == *find_unit("m") / *find_unit("s"));
  CHECK_FALSE(model.velocities[0].unit);
  CHECK(leaf_count(model, Opcode::acceleration) == 2);
  CHECK(leaf_names(model).v == std::vector<std::string>{"", "s[2]"});
}

}  // namespace elgen::test
