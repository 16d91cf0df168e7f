// The model that is left: indices, functions of time in the places of coordinates, users.
#include "check/scene/lock.hpp"

#include <catch2/catch.hpp>

#include "model_text.hpp"
#include "support/models.hpp"

namespace elgen::test {
namespace {

const std::string arm = model_text("arm", R"toml(
[[coordinate]]
name = "a"
armature = "J"
[[coordinate]]
name = "b"
[[coordinate]]
name = "c"
[parameters]
m = 2
J = 3
[energy]
T = "1/2*m*dot(a)^2 + m*dot(a)*dot(b)*cos(a - b) + m*dot(b)^2 + dot(c)^2*a^2"
V = "m*a*b*c"
[[input]]
name = "u"
on = "a"
[[input]]
name = "w"
on = "c"
[[force]]
on = "a"
value = "-5*dot(a)"
[[force]]
on = "b"
value = "-7*dot(a)"
[[expect]]
momentum = ["0", "0", "0"]
)toml");

const CheckedModel& held() {
  static const CheckedModel model =
      checked_scene(arm, "[lock]\na = { value = \"3*t^2\", reaction = true }\n");
  return model;
}

TEST_CASE("what is locked leaves coordinates and velocities", "[lock]") {
  const Model& model = held().model;
  REQUIRE(model.coordinates.size() == 2);
  CHECK(model.coordinates[0].name == "b");
  CHECK(model.coordinates[1].velocity == 1);
  CHECK(model.velocities[1].coordinate == 1);
  CHECK(model.unlocked->coordinates.size() == 3);
  CHECK(model.uses_time);
  CHECK(model.expectations.empty());
  CHECK(held_velocities(model) == std::vector<std::uint32_t>{0});
}

TEST_CASE("inputs and forces on it act only on what holds it", "[lock]") {
  const Model& model = held().model;
  CHECK_FALSE(model.inputs[0].on.has_value());
  CHECK(model.inputs[1].on == 1U);
  REQUIRE(model.forces.size() == 1);
  CHECK(model.forces[0].on == 0U);
}

TEST_CASE("without locks the model is returned as it is", "[lock]") {
  const Model model = checked_model(arm).model;
  CHECK(dump(locked(model)) == dump(model));
  CHECK(held_velocities(model).empty());
}

}  // namespace
}  // namespace elgen::test
