// Complete robots: the text of their models, and the messages.
#include "urdf/draft.hpp"

#include <catch2/catch.hpp>
#include <cstdlib>

#include "elgen/syntax.hpp"
#include "support/shell.hpp"
#include "urdf/urdf_testing.hpp"

namespace elgen::test {

using Catch::Contains;

namespace {

const std::string folder = std::string(ELGEN_SOURCE_DIR) + "/tests/urdf/";

std::string imported_file(const std::string& name) {
  const std::string path = folder + "robots/" + name + ".urdf";
  const SourcePointer source = make_source(path, read_text(path));
  const Result<ImportedModel> model = import_urdf(source, {});
  INFO(format(model.diagnostics));
  REQUIRE(model);
  return model.value->text;
}

}  // namespace

TEST_CASE("the complete model of an arm with one link") {
  CHECK(imported(arm_on("revolute",
                        "<origin xyz=\"0 0 0.5\"/><axis xyz=\"0 1 0\"/>"
                        "<limit lower=\"-1\" upper=\"1\" effort=\"3\" velocity=\"2\"/>"
                        "<dynamics damping=\"0.1\"/>")) ==
        R"(# r, imported from r.urdf.
#
#   base   the world
#     arm  j, revolute
#
# Every link is a frame of its name, every joint that moves a coordinate. Of a joint: x y z its
# origin in the axes of the parent. Of a link, in its own axes: m its mass, cx cy cz its centre
# of mass, Ixx ... its inertia about that. Zeros of the URDF are 0, not parameters.
format = 1

[model]
name        = "r"
title       = "r"
description = "Imported from r.urdf; coordinates are those of its joints."

[[coordinate]]
name       = "j"
unit       = "rad"
range      = [-1, 1]
rate_range = [-2, 2]
doc        = "revolute joint: base to arm"

[parameters]
g = { value = 9.81, unit = "m/s^2", min = 0, max = 25, doc = "gravity" }

# arm, on j
damping_j = { value = 0.1, unit = "N*m*s",  assume = "nonnegative" }
z_j       = { value = 0.5, unit = "m" }
m_arm     = { value = 1,   unit = "kg",     assume = "positive" }
cx_arm    = { value = 0.1, unit = "m" }
Ixx_arm   = { value = 2,   unit = "kg*m^2", assume = "positive" }
Iyy_arm   = { value = 2,   unit = "kg*m^2", assume = "positive" }
Izz_arm   = { value = 2,   unit = "kg*m^2", assume = "positive" }

# j: revolute about y
[[frame]]
name      = "arm"
parent    = "world"
translate = ["0", "0", "z_j"]
rotate    = [["y", "j"]]

[[body]]
name    = "arm"
frame   = "arm"
mass    = "m_arm"
com     = ["cx_arm", "0", "0"]
inertia = ["Ixx_arm", "Iyy_arm", "Izz_arm"]

[gravity]
vector = ["0", "0", "-g"]

[energy]
D = """
  1/2*damping_j*dot(j)^2
"""

[[input]]
name   = "tau_j"
unit   = "N*m"
on     = "j"
limits = [-3, 3]
doc    = "torque of j"
)");
}

TEST_CASE("texts of the file cannot break the model") {
  const std::string model =
      imported(replaced(arm_on("revolute", ""), "\"r\"", "\"a &quot;b&quot;&#10;c\\\""));
  CHECK(after(model, "# a ") == "\"b\"?c\\, imported from r.urdf.");
  CHECK(after(model, "\ntitle ") == R"(      = "a \"b\"\u000Ac\\")");
  CHECK(after(model, "\nname ") == "       = \"a_b_c\"");
}

TEST_CASE("oblique rotations, attitudes and changed names") {
  const std::string model = imported(with_arm(
      "<link name=\"left-leg\"><inertial><mass value=\"1\"/><inertia ixx=\"1\" iyy=\"1\" izz=\"1\" "
      "ixy=\"0.1\" ixz=\"0\" iyz=\"0\"/></inertial></link>"
      "<joint name=\"j\" type=\"floating\"><parent link=\"base\"/><child link=\"arm\"/></joint>"
      "<joint name=\"k\" type=\"revolute\"><parent link=\"arm\"/><child link=\"left-leg\"/>"
      "<axis xyz=\"1 2 0\"/></joint>"));
  CHECK(after(model, "kind  ") == "= \"rotation\"");
  CHECK(after(model, "rotation  ") == "= \"j_attitude\"");
  CHECK(after(model, "rotate ") == "= [[[\"1\", \"2\", \"0\"], \"k\"]]");
  CHECK(after(model, "# `left-leg` ") == "is called left_leg");
  CHECK(after(model, "\"Izz_left_leg\",\n") == "           \"Ixy_left_leg\", \"0\", \"0\"]");
}

TEST_CASE("links follow their parents, each with its parameters, and the tree names all of them") {
  const std::string model = imported(with_arm(
      "<link name=\"tool\"/><joint name=\"tool_joint\" type=\"fixed\"><parent link=\"arm\"/><child "
      "link=\"tool\"/></joint><joint name=\"j\" type=\"revolute\"><parent link=\"base\"/><child "
      "link=\"arm\"/></joint>"));
  CHECK_THAT(model, Contains("#   base      the world\n"
                             "#     arm     j, revolute\n"
                             "#       tool  tool_joint, fixed\n"));
  CHECK_THAT(model, Contains("# arm, on j\nm_arm "));
  CHECK_THAT(model, !Contains("# tool, on"));
  CHECK(model.find("name   = \"arm\"") < model.find("parent = \"arm\""));
  CHECK_THAT(model, !Contains("[[body]]\nname    = \"tool\""));
}

TEST_CASE("a link that does not move has a frame and no body") {
  const std::string model = imported(with_arm(
      "<link name=\"table\"><inertial><mass value=\"9\"/><inertia ixx=\"1\" iyy=\"1\" izz=\"1\" "
      "ixy=\"0\" ixz=\"0\" iyz=\"0\"/></inertial></link>"
      "<joint name=\"f\" type=\"fixed\"><parent link=\"base\"/><child link=\"table\"/></joint>"
      "<joint name=\"j\" type=\"revolute\"><parent link=\"table\"/><child link=\"arm\"/></joint>"));
  CHECK_THAT(model, Contains("[[frame]]\nname   = \"table\""));
  CHECK_THAT(model, !Contains("[[body]]\nname    = \"table\""));
  CHECK_THAT(model, Contains("[[body]]\nname    = \"arm\""));
}

TEST_CASE("robots are imported as the reviewed models") {
  for (const std::string name : {"panda_like", "ur5_like", "quadruped", "humanoid", "gripper"}) {
    INFO(name);
    const std::string model = imported_file(name);
    const std::string golden = folder + "golden/" + name + ".toml";
    if (std::getenv("ELGEN_UPDATE") != nullptr) write_text(golden, model);
    CHECK(model == read_text(golden));
  }
}

TEST_CASE("an imported model is a model file with every number as written") {
  const std::string model = imported_file("panda_like");
  const SourcePointer source = make_source("panda.toml", model);
  const Result<FileSyntax> syntax = parse_model(source, {});
  INFO(format(syntax.diagnostics));
  CHECK(syntax);
  CHECK(after(model, "m_panda_link1 ") ==
        "  = { value = 4.970684,  unit = \"kg\",     assume = \"positive\", latex = 'm_1' }");
}

TEST_CASE("all mistakes of a file are reported together, in the order of the file") {
  CHECK(
      import_messages("<robot name=\"r\">\n"
                      "  <link name=\"a\" color=\"red\"/>\n"
                      "  <link name=\"a\"><inertial><mass value=\"x\"/></inertial></link>\n"
                      "  <joint name=\"j\" type=\"hinge\"><parent link=\"b\"/><child link=\"a\"/>\n"
                      "    <axis xyz=\"0 0\"/><origin xyz=\"1 2 inf\"/></joint>\n"
                      "</robot>\n") ==
      "E815 2:18 attribute `color` of `<link>` is not imported\n"
      "E807 3:15 `a` names two links\n"
      "E803 3:19 `<inertial>` has no element `inertia`\n"
      "E804 3:41 `x` is not a decimal number\n"
      "E806 4:25 `hinge` is no type of joint | there are revolute, continuous, prismatic, fixed, "
      "floating, planar\n"
      "E808 4:46 the robot has no link `b`\n"
      "E804 5:39 `inf` is not finite\n");
}

TEST_CASE("a mistake causes no further ones: a joint without parent makes no second root") {
  const std::string text =
      replaced(arm_on("revolute", "<axis xyz=\"0 x 0\"/>"), "<parent link=\"base\"/>", "");
  CHECK(import_messages(text) ==
        "E803 4:4 `<joint>` has no element `parent`\n"
        "E804 5:14 `x` is not a decimal number\n");
}

TEST_CASE("a model is written despite notes and warnings") {
  const SourcePointer source = make_source("r.urdf", arm_on("revolute", "<sensor/>"));
  const Result<ImportedModel> model = import_urdf(source, {});
  CHECK(model);
  CHECK(messages(model.diagnostics) == "E815 5:2 `<sensor>` in `<joint>` is not imported\n");
}

}  // namespace elgen::test
