// Glossary: the names of links, joints and parameters, and the numbers that become parameters.
#include "urdf/glossary.hpp"

#include <catch2/catch.hpp>

#include "urdf/urdf_testing.hpp"

namespace elgen::test {

namespace {

urdf::Robot same_names() {
  return robot_of(
      "<robot name=\"r\"><link name=\"world\"/><link name=\"knee\"/><link name=\"foot-1\"/>"
      "<joint name=\"knee\" type=\"revolute\"><parent link=\"world\"/><child "
      "link=\"knee\"/></joint>"
      "<joint name=\"foot-1\" type=\"fixed\"><parent link=\"knee\"/><child "
      "link=\"foot-1\"/></joint>"
      "</robot>");
}

}  // namespace

TEST_CASE("a joint keeps its name before a link, and the root link is the world") {
  const urdf::Robot robot = same_names();
  const urdf::Glossary glossary(robot, tree_of(robot));
  CHECK(glossary.joint_name(0) == "knee");
  CHECK(glossary.joint_name(1) == "foot_1");
  CHECK(glossary.frame_name(0) == "world");
  CHECK(glossary.frame_name(1) == "link_knee");
  CHECK(glossary.frame_name(2) == "foot_1");
  CHECK(glossary.name_changes() ==
        std::vector<std::string>{"`foot-1` is called foot_1", "`knee` is called link_knee"});
}

TEST_CASE("a number is a parameter of the current group, a zero is none") {
  const urdf::Robot robot = same_names();
  urdf::Glossary glossary(robot, tree_of(robot));
  glossary.open_group("knee", {});
  CHECK(glossary.add_parameter("m", urdf::make_file_number(0), "kg") == "0");
  CHECK(glossary.add_parameter("g", urdf::make_file_number(2), "kg") == "parameter_g");
  CHECK(glossary.add_parameter("m", urdf::make_file_number(-2), "kg", "assume") == "m");
  const auto& groups = glossary.groups();
  REQUIRE(groups.size() == 1);
  using Rows = std::vector<std::vector<std::string>>;
  CHECK(groups[0].rows == Rows{{"parameter_g", " = { value = 2, ", "unit = \"kg\" }"},
                               {"m", " = { value = -2, ", "unit = \"kg\" }"}});
}

TEST_CASE(
    "joints with long names are numbered in the order of the coordinates, and their parameters "
    "too") {
  urdf::Robot robot = robot_of(
      "<robot name=\"r\"><link name=\"a\"/><link name=\"b\"/><link "
      "name=\"c\"/>" +
      joint("ab") + joint("bc", "prismatic") + "</robot>");
  robot.joints[0].rank = 2;
  robot.joints[1].rank = 1;
  const urdf::LinkTree tree = tree_of(robot);
  urdf::Glossary glossary(robot, tree);
  CHECK(glossary.joint_symbol(0) == "q_2");
  CHECK(glossary.joint_symbol(1) == "q_1");
  glossary.open_group("b", tree.branches[0]);
  const std::vector<std::pair<std::string, std::string>> rows{
      {"m_b", "m_2"},
      {"Ixx_b", "I_{xx,2}"},
      {"z_ab", "z_2"},
      {"damping_ab", "\\mathrm{damping}_2"},
      {"ab_stiction_rate", "\\mathrm{stiction}_2"}};
  for (const auto& [name, symbol] : rows) {
    glossary.add_parameter(name, urdf::make_file_number(-1), "1", "assume = \"positive\"");
    CHECK(glossary.groups()[0].rows.back().back() == "latex = '" + symbol + "' }");
  }
  glossary.add_parameter("ratio_bc", urdf::make_file_number(1), "1");
  CHECK(glossary.groups()[0].rows.back().back() == "unit = \"1\" }");
}

TEST_CASE("joints with short names have no other symbols") {
  const urdf::Robot robot = robot_of(arm_on("revolute", ""));
  CHECK(urdf::Glossary(robot, tree_of(robot)).joint_symbol(0).empty());
}

TEST_CASE("a name consists of letters, digits and single underscores") {
  CHECK(urdf::well_formed_name("panda_link1") == "panda_link1");
  CHECK(urdf::well_formed_name("left-leg.1") == "left_leg_1");
  CHECK(urdf::well_formed_name("a__b") == "a_b");
  CHECK(urdf::well_formed_name("_a_") == "a");
  CHECK(urdf::well_formed_name("1st link") == "n1st_link");
  CHECK(urdf::well_formed_name("\xC3\xA9") == "unnamed");
  CHECK(urdf::well_formed_name("") == "unnamed");
}

TEST_CASE("a name is used once, and is no keyword of C++ or of the model language") {
  urdf::NameRegistry names;
  CHECK(names.claim("arm", "link") == "arm");
  CHECK(names.claim("arm", "link") == "link_arm");
  CHECK(names.claim("arm", "link") == "link_arm_2");
  CHECK(names.claim("union", "link") == "link_union");
  CHECK(names.claim("t", "joint") == "joint_t");
  CHECK(names.claim("INT_arm", "link") == "link_INT_arm");
  CHECK(names.claim("detail", "joint") == "joint_detail");
}

TEST_CASE("a model has the name of its robot in lower case") {
  CHECK(urdf::model_name("UR5 Robot") == "ur5_robot");
  CHECK(urdf::model_name("default") == "robot_default");
}

}  // namespace elgen::test
