// <robot>: what it is called and made of, and files that are something else.
#include <catch2/catch.hpp>

#include "urdf/urdf_testing.hpp"

namespace elgen::test {

TEST_CASE("a robot has the links and joints of its file, in their order") {
  const urdf::Robot robot = robot_of(arm_on("revolute", ""));
  CHECK(robot.file == "r.urdf");
  CHECK(robot.name == "r");
  REQUIRE(robot.links.size() == 2);
  CHECK(robot.links[1].name.text == "arm");
  REQUIRE(robot.joints.size() == 1);
  CHECK(robot.joints[0].child.text == "arm");
}

TEST_CASE("another root element is no robot") {
  CHECK(import_messages("<sdf version=\"1.6\"/>") == "E802 1:2 `<sdf>` is no `<robot>`\n");
}

TEST_CASE("macros are to be expanded first") {
  CHECK(reading_messages("<robot name=\"r\" xmlns:xacro=\"x\">\n<xacro:property name=\"a\"/>\n"
                         "<xacro:arm/></robot>") ==
        "E802 2:2 `<xacro:property>` is a macro | expand the file with xacro first\n");
}

TEST_CASE("materials and transmissions are silent, other elements are noted") {
  CHECK(reading_messages("<robot name=\"r\"><material name=\"red\"/><transmission/>\n"
                         "<gazebo><a/></gazebo></robot>") ==
        "E815 2:2 `<gazebo>` in `<robot>` is not imported\n");
}

}  // namespace elgen::test
