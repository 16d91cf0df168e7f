// let_float: a robot that nothing holds is a body that flies.
#include <catch2/catch.hpp>

#include "urdf/urdf_testing.hpp"

namespace elgen::test {

using Catch::Contains;

namespace {

const std::string flying_body =
    "<inertial><mass value=\"1\"/><inertia ixx=\"1\" iyy=\"1\" izz=\"1\" ixy=\"0\" ixz=\"0\" "
    "iyz=\"0\"/></inertial>";

}  // namespace

TEST_CASE("a robot of one link is a body that flies") {
  const std::string text =
      "<robot name=\"r\"><link name=\"drone\">" + flying_body + "</link></robot>";
  CHECK(import_messages(text) == "E818 1:29 `drone` floats | no joint of the robot moves\n");
  const std::string model = imported(text);
  CHECK(after(model, "#   world    ") == "the world");
  CHECK(after(model, "#     drone  ") == "base, floating");
  CHECK_THAT(model, Contains("name = \"base_x\"\nunit = \"m\"\n"));
  CHECK_THAT(model, Contains("name = \"base_attitude\"\nkind = \"rotation\"\n"));
  CHECK_THAT(model,
             Contains("parent    = \"world\"\ntranslate = [\"base_x\", \"base_y\", \"base_z\"]\n"
                      "rotation  = \"base_attitude\"\n"));
  CHECK_THAT(model, Contains("[[body]]\nname    = \"drone\""));
}

TEST_CASE("so is one whose joints are all fixed") {
  const std::string text =
      "<robot name=\"r\"><link name=\"base\"/><link name=\"world\">" + flying_body +
      "</link>\n<joint name=\"base\" type=\"fixed\"><parent link=\"base\"/><child "
      "link=\"world\"/></joint></robot>";
  const std::string model = imported(text);
  CHECK(after(model, "#   world_2    ") == "the world");
  CHECK(after(model, "#     base     ") == "base_2, floating");
  CHECK_THAT(model, Contains("[[body]]\nname    = \"link_world\""));
}

TEST_CASE("a base floats where it is told to") {
  ImportOptions options;
  options.floating_base = true;
  const std::string model = imported(arm_on("revolute", ""), options);
  CHECK(model.find("base_attitude") < model.find("name = \"j\""));
  CHECK_THAT(model, Contains("name      = \"base\"\nparent    = \"world\""));
  CHECK(import_messages(arm_on("floating", ""), options) ==
        "E821 4:16 `j` floats already | leave out `--floating-base`\n");
}

TEST_CASE("without a mass nothing flies") {
  CHECK(import_messages("<robot name=\"r\"><link name=\"a\"/></robot>") ==
        "E803 1:2 no link of `<robot>` has a `<mass>`\n");
}

}  // namespace elgen::test
