// Coordinates of kind rotation: names, keys and allowed uses.
#include <catch2/catch.hpp>

#include "check_testing.hpp"
#include "numbers/exact_number.hpp"

namespace elgen::test {
namespace {

/// Lines 4 to 6 declare the rotation; `keys` follow on line 7, and `more` ends the file.
std::string flying_top(const std::string& keys = {}, const std::string& more = {}) {
  return "format = 1\n[model]\nname = \"flying\"\n[[coordinate]]\nname = \"e\"\n"
         "kind = \"rotation\"\n" +
         keys + "[parameters]\nJ = 1\n[[frame]]\nname = \"body\"\nparent = \"world\"\n" +
         "rotation = \"e\"\n[[body]]\nname = \"top\"\nframe = \"body\"\n" +
         "inertia = [\"J\", \"2*J\", \"3*J\"]\n" + more;
}

}  // namespace

TEST_CASE("a rotation has four coordinates and three velocities") {
  const Model model =
      checked(flying_top("rate_range = [-5, 5]\nlatex = \"R\"\ndoc = \"attitude\"\n"
                         "start = { value = [0.6, 0, 0.8, 0], rate = [1, \"1/2\", 0] }\n"))
          .model;
  REQUIRE(model.rotations.size() == 1);
  CHECK(model.rotations[0].latex == "R");
  CHECK(model.rotations[0].doc == "attitude");
  REQUIRE(model.coordinates.size() == 4);
  REQUIRE(model.velocities.size() == 3);
  CHECK(model.coordinates[0].name == "e_w");
  CHECK(model.coordinates[3].identifier == "e_z");
  CHECK(model.coordinates[2].start_value == cln::cl_RA(4) / 5);
  CHECK(model.velocities[1].name == "e[2]");
  CHECK(model.velocities[1].identifier == "e_2");
  CHECK(model.velocities[1].start_rate == cln::cl_RA(1) / 2);
  CHECK(model.velocities[2].rate_range->high == 5);
}

TEST_CASE("angular velocities are used like rates and take torques") {
  const std::string forces =
      "[[input]]\nname = \"u\"\nunit = \"N*m\"\non = \"e[2]\"\n"
      "[[force]]\non = \"e[3]\"\nvalue = \"-J*dot(e[3])\"\n";
  const Model model = checked(flying_top("", forces)).model;
  CHECK(model.inputs[0].velocity == 1U);
  CHECK(model.forces[0].velocity == 2U);
  CHECK(dump_lines(flying_top("", forces), "force") == "force  on e[3] = [-J*dot(e[3])]\n");
}

TEST_CASE("a rotation cannot be used as a number") {
  const auto energy = [](const std::string& text) {
    return messages(flying_top("", "[energy]\nV = \"" + text + "\"\n"));
  };
  const std::string hint =
      " | it is the `rotation` of a [[frame]]; its angular velocity is `dot(e[1])` to `dot(e[3])`";
  CHECK(energy("J*e") == "E319 18:8 `e` is a rotation, not a number" + hint + "\n");
  CHECK(energy("J*e[1]") == "E319 18:8 `e[1]` is a rotation, not a number" + hint + "\n");
  CHECK(energy("J*e_w") == "E319 18:8 `e_w` is a component of a rotation, not a number\n");
  CHECK(energy("J*dot(e[4])") == "E207 18:12 there is no `e[4]`: `e` has the elements 1 to 3\n");
  CHECK(energy("J*dot(e)") == "E208 18:12 `e` needs an index: `e` has the elements 1 to 3\n");
}

TEST_CASE("refused keys of a rotation") {
  CHECK(messages(flying_top("range = [0, 1]\n")) == "E112 7:1 a rotation has no `range`\n");
  CHECK(messages(flying_top("wrap = true\n")) == "E112 7:1 a rotation has no `wrap`\n");
  CHECK(messages(flying_top("armature = 1\n")) == "E112 7:1 a rotation has no `armature`\n");
  CHECK(messages(flying_top("singular = \"J\"\n")) == "E112 7:1 a rotation has no `singular`\n");
  CHECK(messages(flying_top("unit = \"m\"\n")) ==
        "E403 7:9 a rotation is a pure number; its angular velocity is in rad/s\n");
  CHECK(messages(flying_top("for = \"i in 1..2\"\n")) ==
        "E112 7:1 a rotation cannot be repeated: its index counts its angular velocities\n");
}

TEST_CASE("the start is a quaternion, normalised, and three rates") {
  const auto start = [](const std::string& value) {
    const Model model = checked(flying_top("start = { value = " + value + " }\n")).model;
    std::vector<cln::cl_R> result;
    for (const Coordinate& q : model.coordinates) result.push_back(q.start_value);
    return result;
  };
  const cln::cl_RA third = cln::cl_RA(1) / 3;
  CHECK(start("[1, 2, -2, 0]") == std::vector<cln::cl_R>{third, 2 * third, -2 * third, 0});
  CHECK(start("[0.6, 0, 0.8, 0]") ==
        std::vector<cln::cl_R>{cln::cl_RA(3) / 5, 0, cln::cl_RA(4) / 5, 0});
  for (const char* value : {"[0.995, 0.0998, 0, 0]", "[1, 1, 0, 0]", "[\"sqrt(2)\", 0, 1e-9, 7]"}) {
    cln::cl_R square = 0;
    for (const cln::cl_R& q : start(value)) square = square + q * q;
    INFO(value);
    CHECK(cln::abs(square - 1) < power_of_ten(-90));  // constants have 100 digits
  }
  CHECK(messages(flying_top("start = { value = [0, 0, 0, 0] }\n")) ==
        "E112 7:19 a quaternion of length 0 has no direction\n");
  CHECK(messages(flying_top("start = { value = 1 }\n")) ==
        "E104 7:19 one number, but a rotation has 4 here\n");
  CHECK(messages(flying_top("start = { rate = [1, 2] }\n")) ==
        "E104 7:18 2 components, but a rotation has 3 here\n");
}

TEST_CASE("names of the components are reserved") {
  CHECK(messages(flying_top("", "[define]\ne_x = 1\n")) ==
        "E203 18:1 `e_x` is already a component of a rotation | first at line 5\n");
}

TEST_CASE("a rotation is used by exactly one frame") {
  const std::string second = "[[frame]]\nname = \"other\"\nparent = \"world\"\nrotation = \"e\"\n";
  CHECK(messages(flying_top("", second)) ==
        "E112 18:9 `e` is already the rotation of the frame `body`\n");
  const std::string alone = "[[coordinate]]\nname = \"f\"\nkind = \"rotation\"\n";
  CHECK(messages(flying_top("", alone)) == "E513 18:9 `f` is the `rotation` of no [[frame]]\n");
}

TEST_CASE("a symplectic step of a rotation is refused before the derivation") {
  const auto step_messages = [](const std::string& method, const std::string& more = {}) {
    const std::string sliding = "[[coordinate]]\nname = \"x\"\n[energy]\nT = \"J*dot(x)^2\"\n";
    return messages(
        flying_top("", sliding),
        {.scene = "format = 1\nmodel = \"m.toml\"\nname = \"s\"\n[outputs]\n" + method + more});
  };
  const std::string hint =
      " does not apply to this system: `e` is a rotation | `rk4` takes any model\n";
  const std::string midpoint = "step = { method = \"midpoint\" }\n";
  CHECK(step_messages(midpoint).find("E622 5:1 `midpoint`" + hint) == 0);
  CHECK(step_messages("step_derivatives = { method = \"verlet\" }\n")
            .find("E622 5:1 `verlet`" + hint) == 0);
  for (const std::string& right :
       {step_messages("step = { method = \"rk4\" }\n"),
        step_messages(midpoint, "[lock]\ne = { value = [1, 0, 0, 0] }\n")}) {
    CHECK_FALSE(mentions(right, "E622"));
  }
}

}  // namespace elgen::test
