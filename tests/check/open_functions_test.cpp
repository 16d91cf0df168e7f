// Open functions: their values and derivatives, and the scenes and samples that close them.
#include <catch2/catch.hpp>

#include "check_testing.hpp"
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

/// A model of a mass in a plane and two sliding masses. Its function U has `arguments` and, on line
/// 14, `sample`. `far` is a definition that uses y, P is the point (x, y), and s is sin(t).
std::string sampled(const std::string& arguments, const std::string& sample) {
  return model_text("sampled", R"toml([[coordinate]]
name = "x"
[[coordinate]]
name = "y"
[[coordinate]]
name = "q[i]"
for = "i in 1..2"
[[function]]
name = "U"
of = [)toml" + arguments + R"toml(]
sample = ")toml" + sample + R"toml("
[parameters]
k = { value = 3 }
[define]
far = "k*y^2"
[[prescribed]]
name = "s"
value = "sin(t)"
[[point]]
name = "P"
at = ["x", "y"]
mass = "k"
[energy]
T = "dot(q[1])^2 + dot(q[2])^2"
[[force]]
on = "x"
value = "U"
)toml");
}

/// The messages about a sample, without the note on missing units.
std::string sample_messages(const std::string& arguments, const std::string& sample) {
  const std::string all = messages(sampled(arguments, sample));
  return all.starts_with("E520") ? "" : all;
}

/// The error that `sample` at `place` depends on `leaf`, although no argument of U does.
std::string unlisted_leaf_message(const std::string& sample, const std::string& leaf,
                                  const std::string& place = "14:11") {
  return "E319 " + place + " `" + sample + "` depends on `" + leaf +
         "`, but no argument of `U` does | `of` lists every argument of the function\n";
}

/// The open values of `model`, such as "V [J], V_1 [N], …".
std::string open_values(const Model& model) {
  std::string text;
  for (const OpenValue& value : model.open_values) {
    text += (text.empty() ? "" : ", ") + value.name + " [" + value.unit_text + "]";
  }
  return text;
}

/// The only definition and the number of expectations of `closed`, such as "V = k*x*y, 2 expected".
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

TEST_CASE("an open function has its value and its derivatives up to order two") {
  const Model model = checked_model(plane).model;
  CHECK(open_values(model) ==
        "V [J], V_1 [N], V_2 [N], V_11 [kg/s^2], V_12 [kg/s^2], V_22 [kg/s^2]");
  CHECK(leaf_count(model, Opcode::open_value) == 6);
  CHECK(leaf_text(model, Opcode::open_value, 4) == "V_12");
  CHECK(model.expectations.size() == 2);
}

TEST_CASE("mixed derivatives of open functions are symmetric") {
  const Model model = checked_model(plane).model;
  CHECK(find_open_derivative(model, 0, 1) == 2U);
  CHECK(find_open_derivative(model, 1, 1) == 4U);
  CHECK(find_open_derivative(model, 2, 0) == 4U);
  CHECK_FALSE(find_open_derivative(model, 4, 0).has_value());
}

TEST_CASE("a scene or a sample closes an open function") {
  const CheckedModel by_scene = checked_scene(plane, "[functions]\nV = \"k*x*y\"\n");
  CHECK(closed_text(by_scene) == "V = k*x*y, 1 expected");
  CHECK(mentions(by_scene.scene.canonical_text, "functions"));
  SceneOptions options;
  options.purpose = purpose::rest;
  CHECK(closed_text(checked_model(plane, options)) == "V = 1/2*k*(x^2 + y^2), 1 expected");
}

TEST_CASE("an expression of a function may use the leaves of its arguments") {
  CHECK(sample_messages("'x'", "k*x^2 + sin(x)") == "");
  CHECK(sample_messages("'x', 'y'", "far*x(P)") == "");
  CHECK(sample_messages("'sqrt(x^2 + y^2)'", "k*x(P) + far") == "");
  CHECK(sample_messages("'q[1]', 'q[2]'", "sum(i, 1, 2, q[i]^2)") == "");
  CHECK(sample_messages("'dot(x)'", "k*dot(x)^2 + dot(x(P))") == "");
  CHECK(sample_messages("'dot(x)', 'dot(y)'", "v2(P)") == "");
  CHECK(sample_messages("'dot(far)'", "y*dot(y)") == "");
  CHECK(sample_messages("'x', 't'", "x*s") == "");
}

TEST_CASE("an error names each leaf outside the arguments of the function") {
  const auto of_x = [](const std::string& sample) { return sample_messages("'x'", sample); };
  CHECK(of_x("1/2*k*(x^2 + y^2)") == unlisted_leaf_message("1/2*k*(x^2 + y^2)", "y"));
  CHECK(of_x("x*far") == unlisted_leaf_message("x*far", "y"));
  CHECK(of_x("x + y(P)") == unlisted_leaf_message("x + y(P)", "y"));
  CHECK(of_x("x*cos(t)") == unlisted_leaf_message("x*cos(t)", "t"));
  CHECK(of_x("x*s") == unlisted_leaf_message("x*s", "t"));
  CHECK(of_x("x*dot(x)") == unlisted_leaf_message("x*dot(x)", "dot(x)"));
  CHECK(of_x("v2(P)") ==
        unlisted_leaf_message("v2(P)", "dot(x)") + unlisted_leaf_message("v2(P)", "dot(y)"));
  CHECK(sample_messages("'dot(x)'", "x*dot(x)") == unlisted_leaf_message("x*dot(x)", "x"));
  CHECK(sample_messages("'q[1]'", "q[1]*q[2]") == unlisted_leaf_message("q[1]*q[2]", "q[2]"));
}

TEST_CASE("an expression in a scene may only use the arguments of the function, too") {
  CheckOptions wanted;
  wanted.scene =
      "format = 1\nmodel = \"model.toml\"\nname = \"wide\"\n[functions]\nU = \"k*x*y\"\n";
  CHECK(messages(sampled("'x'", "x"), wanted) == unlisted_leaf_message("k*x*y", "y", "5:6"));
}

TEST_CASE("derivatives of a function with a refused name are not reported as unknown") {
  const auto called = [](const std::string& name) {
    return messages(model_text(
        "line", "[[coordinate]]\nname = \"x\"\n[[function]]\nname = \"" + name +
                    "\"\nof = [\"x\"]\n[energy]\nT = \"dot(x)^2\"\nV = \"" + name +
                    "\"\n[[expect]]\ngravity = [\"" + name + "_1\"]\nposition_gradient = [\"-" +
                    name + "_1 + 0*" + name + "_11\"]\n"));
  };
  CHECK(called("I") == "E204 7:9 `I` is reserved: it is a macro of C or C++ | `J` is free\n");
  CHECK(called("a_") ==
        "E204 7:9 `a__1` is reserved: names with two underscores in a row belong to C++"
        " | `a_1` is free\n");
  CHECK_FALSE(mentions(called("U"), "E20"));
}

}  // namespace elgen::test
