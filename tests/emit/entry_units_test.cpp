// entry_units: the units of a cart (m) and pole (rad) pushed by a force (N), field by field.
#include "emit/text/entry_units.hpp"

#include "fixture.hpp"

using namespace elgen;
using elgen::testing::cart_pole_model;

TEST_CASE("rows are separated by semicolons, equal units are one") {
  const Model model = cart_pole_model();
  CHECK(units_text(model, OutputKind::mass_matrix, {"", 2, 2, {}}) == "kg, kg*m; kg*m, kg*m^2");
  CHECK(units_text(model, OutputKind::forward_dynamics, {"relative_pivots", 2, 1, {}}) == "1");
  CHECK(units_text(model, OutputKind::kinetic_energy, {"", 1, 1, {}}) == "J");
}

TEST_CASE("an unknown unit leaves the rest unsaid") {
  Model model = cart_pole_model();
  model.velocities[1].unit.reset();
  CHECK(units_text(model, OutputKind::mass_matrix, {"", 2, 2, {}}) == "");
}
