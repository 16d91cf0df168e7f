// model_text: the text of a model file, table by table, and what its head tells.
#include "urdf/draft.hpp"

#include <catch2/catch.hpp>

#include "urdf/urdf_testing.hpp"

namespace elgen::test {

using Catch::Contains;

TEST_CASE("an arm of one link, whole") {
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
# of mass, Ixx ... its inertia about that. What the URDF has as 0 is 0, not a parameter.
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
  std::string text = arm_on("revolute", "");
  text.replace(text.find("\"r\""), 3, "\"a &quot;b&quot;&#10;c\\\"");
  const std::string model = imported(text);
  CHECK(after(model, "# a ") == "\"b\"?c\\, imported from r.urdf.");
  CHECK(after(model, "\ntitle ") == R"(      = "a \"b\"\u000Ac\\")");
  CHECK(after(model, "\nname ") == "       = \"a_b_c\"");
}

TEST_CASE("oblique turns, attitudes and changed names") {
  const std::string model = imported(with_arm(
      "<link name=\"left-leg\"><inertial><mass value=\"1\"/><inertia ixx=\"1\" iyy=\"1\" izz=\"1\" "
      "ixy=\"0.1\" ixz=\"0\" iyz=\"0\"/></inertial></link>"
      "<joint name=\"j\" type=\"floating\"><parent link=\"base\"/><child link=\"arm\"/></joint>"
      "<joint name=\"k\" type=\"revolute\"><parent link=\"arm\"/><child link=\"left-leg\"/>"
      "<axis xyz=\"1 2 0\"/></joint>"));
  CHECK(after(model, "kind ") == "= \"rotation\"");
  CHECK(after(model, "rotation  ") == "= \"j_attitude\"");
  CHECK(after(model, "rotate ") == "= [[[\"1\", \"2\", \"0\"], \"k\"]]");
  CHECK(after(model, "# `left-leg` ") == "is called left_leg");
  CHECK(after(model, "\"Izz_left_leg\",\n") == "           \"Ixy_left_leg\", \"0\", \"0\"]");
}

TEST_CASE("links come with their parents first, each with its parameters, the tree names all") {
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

}  // namespace elgen::test
