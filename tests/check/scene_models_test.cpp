// Changes of a model by a scene: locks, the model without the locked coordinates, and the point of
// an expansion.
#include <catch2/catch.hpp>

#include "check/scene/scene.hpp"
#include "check_testing.hpp"
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

const CheckedModel& locked_model() {
  static const CheckedModel model =
      checked_scene(arm, "[lock]\na = { value = \"3*t^2\", reaction = true }\n");
  return model;
}

/// A model with x, q[1] and q[2] in m, a rotation, and a time constant T.
const std::string body = R"toml(format = 1
[model]
name = "body"
[[coordinate]]
name = "x"
unit = "m"
[[coordinate]]
name = "q[i]"
for  = "i in 1..2"
unit = "m"
[[coordinate]]
name = "attitude"
kind = "rotation"
[parameters]
m = { value = 1, unit = "kg" }
T = { value = 2, unit = "s" }
l = { value = 3, unit = "m" }
[[frame]]
name = "hull"
parent = "world"
rotation = "attitude"
[energy]
T = "1/2*m*(dot(x)^2 + dot(q[1])^2 + dot(q[2])^2 + l^2*(dot(attitude[1])^2 + dot(attitude[2])^2 + dot(attitude[3])^2))"
)toml";

CheckOptions locking(const std::string& lines) {
  return {.scene = "format = 1\nmodel = \"body.toml\"\nname = \"held\"\n[lock]\n" + lines};
}

std::string lock_messages(const std::string& lines) { return messages(body, locking(lines)); }

std::vector<LockedCoordinate> locks(const std::string& lines) {
  return checked(body, locking(lines)).model.reduction.locks;
}

const std::string two_angles = R"toml(format = 1
[model]
name = "two"
[[coordinate]]
for = "i in 1..2"
name = "q[i]"
unit = "rad"
[[coordinate]]
name = "x"
unit = "m"
[parameters]
m = { value = 1, unit = "kg" }
h = { value = 1, unit = "m" }
[energy]
T = "1/2*m*(dot(x)^2 + h^2*(dot(q[1])^2 + dot(q[2])^2))"
[[input]]
name = "F"
unit = "N"
on = "x"
)toml";

CheckOptions expansion_options(const std::string& lines) {
  CheckOptions wanted;
  wanted.scene =
      "format = 1\nmodel = \"two.toml\"\nname = \"near\"\n[approximate]\n" + lines + "\n";
  return wanted;
}

std::string approximation_messages(const std::string& lines) {
  std::string text = messages(two_angles, expansion_options(lines));
  if (!text.empty()) text.pop_back();  // the final line end
  return text;
}

std::string approximation(const std::string& lines) {
  return dump_lines(two_angles, "approximate", expansion_options(lines));
}

}  // namespace

TEST_CASE("an output of the scene keeps the inputs that it uses", "[lock]") {
  const std::string sensor =
      arm + "[[output]]\nname = \"o\"\njacobian = true\nvalue = \"dot(b) + u\"\n";
  const auto inputs = [](const std::string& model, const std::string& outputs,
                         const std::vector<std::string>& options = {}) {
    CheckOptions wanted;
    wanted.scene = "format = 1\nmodel = \"arm.toml\"\nname = \"held\"\n" + outputs +
                   "[lock]\na = { value = \"0.3\", reaction = true }\n";
    wanted.outputs = options;
    std::string names;
    for (const Input& input : checked(model, wanted).model.inputs) names += input.name;
    return names;
  };
  const std::string matrix = "[outputs]\ninput_matrix = true\n";
  CHECK(inputs(arm, "") == "w");
  CHECK(inputs(arm, matrix) == "w");
  CHECK(inputs(sensor, matrix) == "w");
  CHECK(inputs(sensor, matrix + "o = false\n") == "w");
  CHECK(inputs(sensor, matrix, {"forward_dynamics"}) == "w");
  CHECK(inputs(sensor, "") == "uw");
  CHECK(inputs(sensor, matrix + "o = true\n") == "uw");
  CHECK(inputs(sensor, matrix + "o_derivatives = true\n") == "uw");
  CHECK(inputs(sensor, matrix, {"o"}) == "uw");
}

TEST_CASE("a locked coordinate is removed from coordinates and velocities", "[lock]") {
  const Model& model = locked_model().model;
  REQUIRE(model.coordinates.size() == 2);
  CHECK(model.coordinates[0].name == "b");
  CHECK(model.coordinates[1].velocity == 1);
  CHECK(model.velocities[1].coordinate == 1);
  CHECK(unreduced_model(model).coordinates.size() == 3);
  CHECK(model.uses_time);
  CHECK(model.expectations.empty());
  CHECK(reaction_row_velocities(model) == std::vector<std::uint32_t>{0});
}

TEST_CASE("inputs and forces on a locked coordinate are removed with it", "[lock]") {
  const Model& model = locked_model().model;
  REQUIRE(model.inputs.size() == 1);  // the input on the locked coordinate is removed
  CHECK(model.inputs[0].velocity == 1U);
  REQUIRE(model.forces.size() == 1);
  CHECK(model.forces[0].velocity == 0U);
}

TEST_CASE("a law stays with its input if other inputs are removed", "[lock]") {
  const SourcePointer source = make_source(
      "a.scene.toml", "format = 1\nmodel = \"m.toml\"\nname = \"a\"\n[lock]\na = { value = 0 }\n");
  const auto scene = parse_scene(source, {});
  REQUIRE(scene);
  SceneOptions options;
  options.laws = {make_source("command line", "w=-2*c")};
  const CheckedModel checked = checked_model(arm, &*scene, options);
  REQUIRE(checked.model.inputs.size() == 1);
  const ExpressionId* const law = find_law(checked.scene, checked.model.inputs.front());
  REQUIRE(law != nullptr);
  CHECK(to_string(checked.model, *law) == "-2*c");
}

TEST_CASE("a page adds outputs, and the scene lists them") {
  SceneOptions options;
  options.laws = {make_source("command line", "w=-2*c")};
  CHECK(checked_model(arm, options).scene.page_outputs.empty());
  options.purpose = purpose::show_motion;
  const auto [model, scene] = checked_model(arm, options);
  REQUIRE(scene.page_outputs.size() == 1);
  const auto& [number, shown] = *scene.page_outputs.begin();
  CHECK(shown == ShownValues::laws);
  CHECK(model.outputs[number].name == "shown_laws");
  options.laws = {make_source("command line", "w=-2*min(c, 1)")};
  const CheckedModel kinked = checked_model(arm, options);
  REQUIRE(kinked.scene.page_outputs.size() == 2);
  const auto& [last, kinks] = *kinked.scene.page_outputs.rbegin();
  CHECK(kinks == ShownValues::kinks);
  CHECK(kinked.model.outputs[last].values.size() == 2);
}

TEST_CASE("without locks the model is unchanged", "[lock]") {
  const Model model = checked_model(arm).model;
  CHECK(dump(eliminate_held_coordinates(model)) == dump(model));
  CHECK(reaction_row_velocities(model).empty());
}

TEST_CASE("locks are in the order of the coordinates", "[lock]") {
  const std::vector<LockedCoordinate> found = locks(
      "attitude = { value = [0, 0, 0, 2], reaction = true }\n\"q[2]\" = { value = 1 }\n"
      "x = { value = \"l*t/T\" }\n");
  REQUIRE(found.size() == 3);
  CHECK(found[0].coordinate == 0);
  CHECK(found[1].coordinate == 2);
  CHECK(found[2].coordinate == 3);
  CHECK(found[2].velocity == 3);
  CHECK(found[2].values.size() == 4);
  CHECK_FALSE(found[0].has_reaction);
  CHECK(found[2].has_reaction);
}

TEST_CASE("a quaternion is normalised", "[lock]") {
  const CheckedModel held = checked(body, locking("attitude = { value = [0, 3, 0, -4] }\n"));
  const Model& model = unreduced_model(held.model);
  const LockedCoordinate& lock = model.reduction.locks.front();
  CHECK(model.expressions[lock.values[1]].number == cln::cl_RA(3) / 5);
  CHECK(model.expressions[lock.values[3]].number == -cln::cl_RA(4) / 5);
}

TEST_CASE("values without a unit are in the unit of the coordinate", "[lock]") {
  CHECK(lock_messages("x = { value = 0.3 }\n").empty());
  CHECK(lock_messages("x = { value = \"0.1*sin(2*pi*t)\" }\n").empty());
  CHECK(lock_messages("x = { value = \"l + m\" }\n") ==
        "E401 5:20 `m` is in kg, but the sum is in m\n");
  CHECK(lock_messages("x = { value = \"m\" }\n") ==
        "E403 5:16 `m` is in kg, but the value of a lock is in m\n");
}

TEST_CASE("refused locks", "[lock]") {
  CHECK(lock_messages("z = { value = 0 }\n").rfind("E612 5:1 unknown coordinate `z`", 0) == 0);
  CHECK(lock_messages("attitud = { value = 0 }\n") ==
        "E612 5:1 unknown coordinate `attitud` | did you mean `attitude`? (rotation, line 12)\n");
  CHECK(lock_messages("attitude_w = { value = 0 }\n")
            .rfind("E612 5:1 unknown coordinate `attitude_w`", 0) == 0);
  CHECK(lock_messages("q = { value = 0 }\n") ==
        "E208 5:1 `q` needs an index: `q` has the elements 1 to 2\n");
  CHECK(lock_messages("x = { value = \"q[1]\" }\n") ==
        "E319 5:16 `q[1]` is a coordinate, but the value of a lock takes none\n");
  CHECK(lock_messages("x = { value = [1, 2] }\n") ==
        "E615 5:15 a list, but the coordinate is one number\n");
  CHECK(lock_messages("attitude = { value = [1, 2] }\n") ==
        "E615 5:22 `[1, 2]` is not a quaternion [w, x, y, z]\n");
  CHECK(lock_messages("attitude = { value = [0, 0, 0, 0] }\n") ==
        "E615 5:22 a quaternion of length 0 has no direction\n");
  CHECK(lock_messages("x = { value = 0 }\n\"q[1]\" = { value = 0 }\n\"q[2]\" = { value = 0 }\n"
                      "attitude = { value = [1, 0, 0, 0] }\n") ==
        "E615 4:1 every coordinate is locked, so nothing moves\n");
}

TEST_CASE("a scene without locks keeps no second model", "[lock]") {
  CHECK(checked(body).model.reduction.unreduced == nullptr);
}

TEST_CASE("an expansion point names arrays, elements, coordinates and inputs") {
  CHECK(approximation("order = 2\nabout = { q = 0, x = \"h/2\", F = 3 }") ==
        "approximate order 2 about q[1] = 0, q[2] = 0, x = h/2, F = 3 with q[1], q[2], x small\n");
  CHECK(approximation("order = 1\nabout = { \"q[2]\" = \"pi\" }") ==
        "approximate order 1 about q[2] = pi with q[2] small\n");
  CHECK(approximation("order = 1\nabout = { x = 0, q = 0 }\nsmall = [\"q[1]\"]") ==
        "approximate order 1 about q[1] = 0, q[2] = 0, x = 0 with q[1] small\n");
}

TEST_CASE("inputs are small if all coordinates are") {
  CHECK(checked(two_angles, expansion_options("order = 1\nabout = { q = 0, x = 0 }"))
            .model.approximation->has_small_inputs);
  CHECK_FALSE(checked(two_angles, expansion_options("order = 1\nabout = { q = 0 }"))
                  .model.approximation->has_small_inputs);
}

TEST_CASE("orders are 1 to 5") {
  CHECK(approximation_messages("order = 0\nabout = { x = 0 }") ==
        "E614 5:9 order `0` is not one of 1 to 5");
  CHECK(approximation_messages("order = 6\nabout = { x = 0 }") ==
        "E614 5:9 order `6` is not one of 1 to 5");
}

TEST_CASE("only coordinates with a value in `about` are small") {
  CHECK(approximation_messages("order = 1\nabout = { y = 0 }") ==
        "E614 6:11 `y` is no coordinate or input");
  CHECK(approximation_messages("order = 1\nabout = { x = 0 }\nsmall = [\"q[1]\"]") ==
        "E614 7:11 `q[1]` is small, but `about` gives no value for it | add its value to `about`");
  CHECK(approximation_messages("order = 1\nabout = { F = 0 }") ==
        "E614 6:1 no coordinate is small | `about` gives the small coordinates");
}

TEST_CASE("values use parameters only, and have the unit of their coordinate or input") {
  CHECK(approximation_messages("order = 1\nabout = { x = \"t\" }").substr(0, 9) == "E319 6:16");
  CHECK(approximation_messages("order = 1\nabout = { x = \"m\" }").substr(0, 9) == "E403 6:16");
}

}  // namespace elgen::test
