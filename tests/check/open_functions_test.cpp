// SPDX-License-Identifier: GPL-3.0-or-later
// Functions left open: their values, and what closes them.
#include <catch2/catch.hpp>

#include "elgen/leaf_names.hpp"
#include "support/models.hpp"

namespace elgen::test {

namespace {

const std::string plane = model_text("plane", R"toml([[coordinate]]
name = "x"
unit = "m"
[[coordinate]]
name = "y"
unit = "m"
[parameters]
m = { value = 2, unit = "kg" }
k = { value = 3, unit = "N/m" }
[[function]]
name = "V"
of = ["x", "y"]
unit = "J"
sample = "1/2*k*(x^2 + y^2)"
[energy]
T = "1/2*m*(dot(x)^2 + dot(y)^2)"
V = "V"
[[expect]]
gravity = ["V_1", "V_2"]
potential_energy = "V"
)toml");

/// "V [J], V_1 [N], …"
std::string open_values(const Model& model) {
  std::string text;
  for (const OpenValue& value : model.open_values) {
    text += (text.empty() ? "" : ", ") + value.name + " [" + value.unit_text + "]";
  }
  return text;
}

/// "V = k*x*y", of the one definition, and how many closed forms there are.
std::string closed_text(const CheckedModel& closed) {
  const Model& model = closed.model;
  REQUIRE(model.functions.empty());
  REQUIRE(model.open_values.empty());
  REQUIRE(model.definitions.size() == 1);
  const NamedExpression& definition = model.definitions.front();
  return definition.name + " = " + to_string(model, definition.value) + ", " +
         std::to_string(model.expectations.size()) + " expected";
}

}  // namespace

TEST_CASE("an open function has its value and derivatives up to the second") {
  const Model model = checked_model(plane).model;
  CHECK(open_values(model) ==
        "V [J], V_1 [N], V_2 [N], V_11 [kg/s^2], V_12 [kg/s^2], V_22 [kg/s^2]");
  CHECK(leaf_count(model, Opcode::open_value) == 6);
  CHECK(leaf_text(model, Opcode::open_value, 4) == "V_12");
  CHECK(model.expectations.size() == 2);
}

TEST_CASE("derivatives of open values do not depend on their order") {
  const Model model = checked_model(plane).model;
  CHECK(derivative_of(model, 0, 1) == 2U);
  CHECK(derivative_of(model, 1, 1) == 4U);
  CHECK(derivative_of(model, 2, 0) == 4U);
  CHECK_FALSE(derivative_of(model, 4, 0).has_value());
}

TEST_CASE("a scene or a sample closes an open function") {
  const CheckedModel by_scene = checked_scene(plane, "[functions]\nV = \"k*x*y\"\n");
  CHECK(closed_text(by_scene) == "V = k*x*y, 1 expected");
  CHECK(by_scene.scene.canonical.find("functions") != std::string::npos);
  SceneOptions options;
  options.close_functions = true;
  CHECK(closed_text(checked_model(plane, options)) == "V = 1/2*k*(x^2 + y^2), 1 expected");
}

}  // namespace elgen::test
