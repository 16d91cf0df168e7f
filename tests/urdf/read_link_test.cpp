// <link>: mass and inertia.
#include <catch2/catch.hpp>

#include "urdf/urdf_testing.hpp"

namespace elgen::test {

namespace {

std::string link(const std::string& inside) {
  return "<robot name=\"r\"><link name=\"a\">\n" + inside + "\n</link></robot>";
}

}  // namespace

TEST_CASE("an inertial is read in the order xx yy zz xy xz yz") {
  const urdf::Robot robot = robot_of(
      link("<inertial><origin xyz=\"1 2 3\" rpy=\"0 0 1\"/><mass value=\"4\"/><inertia ixx=\"1\" "
           "ixy=\"2\" ixz=\"3\" iyy=\"4\" iyz=\"5\" izz=\"6\"/></inertial>"));
  const urdf::Inertial& inertial = *robot.links[0].inertial;
  CHECK(robot.links[0].has_mass());
  CHECK(inertial.mass.text == "4");
  CHECK(inertial.origin.xyz[1].text == "2");
  CHECK(inertial.origin.rpy[2].text == "1");
  std::string order;
  for (const urdf::FileNumber& number : inertial.inertia) order += number.text;
  CHECK(order == "146235");
}

TEST_CASE("a link without inertial has no mass, and shapes are silent") {
  const std::string text = link("<visual/><visual/><collision/>");
  CHECK(reading_messages(text).empty());
  CHECK_FALSE(robot_of(text).links[0].has_mass());
}

TEST_CASE("an inertial has a mass and six inertias") {
  CHECK(reading_messages(link("<inertial/>")) ==
        "E803 2:2 `<inertial>` has no element `inertia`\n"
        "E803 2:2 `<inertial>` has no element `mass`\n");
  CHECK(reading_messages(link("<inertial><mass/><inertia ixx=\"1\" iyy=\"1\" izz=\"1\"/>"
                              "</inertial>")) ==
        "E803 2:12 `<mass>` has no attribute `value`\n"
        "E803 2:19 `<inertia>` has no attribute `ixy`\n"
        "E803 2:19 `<inertia>` has no attribute `ixz`\n"
        "E803 2:19 `<inertia>` has no attribute `iyz`\n");
}

TEST_CASE("no mass is negative") {
  CHECK(reading_messages(link("<inertial><mass value=\"-2\"/><inertia ixx=\"1\" ixy=\"0\" "
                              "ixz=\"0\" iyy=\"1\" iyz=\"0\" izz=\"1\"/></inertial>")) ==
        "E811 2:24 the mass `-2` is negative\n");
}

}  // namespace elgen::test
