// entry_units: the unit of every kind of entry of a cart (m) and pole (rad) pushed by a force (N).
#include "emit/entry_units.hpp"

#include "fixture.hpp"

using namespace elgen;
using elgen::testing::cart_pole_model;

namespace {

std::string unit(OutputKind kind, std::size_t row, std::size_t column = 0) {
  const std::optional<Unit> found = unit_of_entry(cart_pole_model(), {kind, "", row, column});
  return found ? to_string(*found) : "none";
}

std::string spelled(const char* name) { return to_string(*find_unit(name)); }

}  // namespace

TEST_CASE("units follow from those of the velocities") {
  CHECK(unit(OutputKind::mass_matrix, 0, 0) == "kg");
  CHECK(unit(OutputKind::mass_matrix, 0, 1) == "kg*m");
  CHECK(unit(OutputKind::mass_matrix, 1, 1) == "kg*m^2");
  CHECK(unit(OutputKind::coriolis_matrix, 0, 0) == "kg/s");
  CHECK(unit(OutputKind::bias, 0) == spelled("N"));
  CHECK(unit(OutputKind::bias, 1) == spelled("J"));
  CHECK(unit(OutputKind::momentum, 0) == "kg*m/s");
  CHECK(unit(OutputKind::kinetic_energy, 0) == spelled("J"));
  CHECK(unit(OutputKind::input_matrix, 0, 0) == "1");
  CHECK(unit(OutputKind::input_matrix, 1, 0) == "m");
  CHECK(unit(OutputKind::forward_dynamics, 0) == "m/s^2");
  CHECK(unit(OutputKind::user_value, 0) == "none");
}

TEST_CASE("an unknown unit leaves the rest unsaid") {
  Model model = cart_pole_model();
  model.velocities[1].unit.reset();
  CHECK_FALSE(unit_of_entry(model, {OutputKind::mass_matrix, "", 0, 1}));
  CHECK(unit_of_entry(model, {OutputKind::mass_matrix, "", 0, 0}));
  CHECK(units_text(model, OutputKind::mass_matrix, {"", 2, 2, {}}) == "");
}

TEST_CASE("lists of units") {
  const Model model = cart_pole_model();
  CHECK(units_text(model, OutputKind::mass_matrix, {"", 2, 2, {}}) == "kg, kg*m; kg*m, kg*m^2");
  CHECK(units_text(model, OutputKind::forward_dynamics, {"relative_pivots", 2, 1, {}}) == "1");
}
