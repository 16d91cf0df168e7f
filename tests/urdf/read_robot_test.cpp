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

TEST_CASE("a robot without a name is called as its file") {
  const urdf::Robot robot = robot_of("<robot><link name=\"a\"/></robot>");
  CHECK(robot.name == "r");
  CHECK(robot.model == "r");
}

TEST_CASE("another root element is no robot") {
  CHECK(import_messages("<sdf version=\"1.6\"/>") ==
        "E802 1:2 `<sdf>` is SDF, and elgen reads URDF | convert it to URDF first\n");
}

TEST_CASE("so is MJCF, and whatever else") {
  CHECK(import_messages("<mujoco/>") ==
        "E802 1:2 `<mujoco>` is MJCF, and elgen reads URDF | convert it to URDF first\n");
  CHECK(import_messages("<svg/>") == "E802 1:2 `<svg>` is no `<robot>`\n");
}

TEST_CASE("a file to be expanded has no other mistakes yet") {
  CHECK(import_messages("<robot name=\"r\"><xacro:arm/>\n<joint name=\"${j}\"/></robot>") ==
        "E802 1:18 `<xacro:arm>` is a macro of xacro | expand the file first: `xacro FILE > "
        "robot.urdf`, in ROS 2 `ros2 run xacro xacro FILE > robot.urdf`\n");
}

TEST_CASE("what xacro left nothing of is told") {
  CHECK(import_messages("<robot xmlns:xacro=\"x\"></robot>") ==
        "E803 1:2 `<robot>` has no element `link` | xacro expanded no macro here: expand the file "
        "that calls them\n");
}

TEST_CASE("macros are to be expanded first") {
  CHECK(reading_messages("<robot name=\"r\" xmlns:xacro=\"x\">\n<xacro:property name=\"a\"/>\n"
                         "<xacro:arm/></robot>") ==
        "E802 2:2 `<xacro:property>` is a macro of xacro | expand the file first: `xacro FILE > "
        "robot.urdf`, in ROS 2 `ros2 run xacro xacro FILE > robot.urdf`\n");
}

TEST_CASE("materials and transmissions are silent, other elements are noted") {
  CHECK(reading_messages("<robot name=\"r\"><material name=\"red\"/><transmission/>\n"
                         "<gazebo><a/></gazebo></robot>") ==
        "E815 2:2 `<gazebo>` in `<robot>` is not imported\n");
}

}  // namespace elgen::test
