// draft_body: masses, centres and inertias in the axes of the link.
#include <catch2/catch.hpp>

#include "urdf/drafting.hpp"
#include "urdf/urdf_testing.hpp"

namespace elgen::test {

namespace {

/// The draft of the link `b`, which turns about z, with this inertial.
urdf::LinkDraft link_with(const std::string& inertial) {
  const urdf::Robot robot =
      robot_of("<robot name=\"r\"><link name=\"a\"/><link name=\"b\"><inertial>" + inertial +
               "</inertial></link><joint name=\"j\" type=\"revolute\"><parent link=\"a\"/><child "
               "link=\"b\"/></joint></robot>");
  return urdf::make_draft(robot, tree_of(robot)).links.back();
}

std::string inertia(const std::string& off_diagonal) {
  return "<inertia ixx=\"1\" iyy=\"2\" izz=\"3\" ixy=\"" + off_diagonal +
         "\" ixz=\"0\" iyz=\"0\"/>";
}

using Names = std::vector<std::string>;

}  // namespace

TEST_CASE("a body has its numbers as parameters, and zeros as zeros") {
  const urdf::LinkDraft link =
      link_with("<origin xyz=\"0 0.5 0\"/><mass value=\"4\"/>" + inertia("0"));
  REQUIRE(link.bodies.size() == 1);
  const urdf::BodyDraft& body = link.bodies[0];
  CHECK(body.name == "b");
  CHECK(body.frame == "b");
  CHECK(body.mass == "m_b");
  CHECK(body.com == urdf::Components{"0", "cy_b", "0"});
  CHECK(body.inertia == Names{"Ixx_b", "Iyy_b", "Izz_b"});
}

TEST_CASE("products of inertia make six") {
  const urdf::LinkDraft link = link_with("<mass value=\"4\"/>" + inertia("0.1"));
  CHECK(link.bodies[0].inertia == Names{"Ixx_b", "Iyy_b", "Izz_b", "Ixy_b", "0", "0"});
}

TEST_CASE("an inertia in axes turned by right angles stays in the link's") {
  const urdf::LinkDraft link =
      link_with("<origin rpy=\"0 0 1.5708\"/><mass value=\"4\"/>" + inertia("0"));
  CHECK(link.frames.size() == 1);
  CHECK(link.bodies[0].comments == Names{"inertia turned from axes of rpy 0 0 1.5708"});
}

TEST_CASE("an inertia in oblique axes has a frame of its own at the centre of mass") {
  const urdf::LinkDraft link =
      link_with("<origin xyz=\"1 0 0\" rpy=\"0 0 0.3\"/><mass value=\"4\"/>" + inertia("0"));
  REQUIRE(link.frames.size() == 2);
  CHECK(link.frames[1].name == "b_inertial");
  CHECK(link.frames[1].parent == "b");
  CHECK(link.frames[1].translate == urdf::Components{"cx_b", "0", "0"});
  CHECK(link.bodies[0].frame == "b_inertial");
  CHECK(link.bodies[0].com == urdf::Components{"0", "0", "0"});
}

TEST_CASE("a mass without inertia is a point") {
  const urdf::LinkDraft link = link_with(
      "<origin rpy=\"0 0 0.3\"/><mass value=\"4\"/><inertia ixx=\"0\" iyy=\"0\" izz=\"0\" "
      "ixy=\"0\" ixz=\"0\" iyz=\"0\"/>");
  CHECK(link.frames.size() == 1);
  CHECK(link.bodies[0].inertia.empty());
}

}  // namespace elgen::test
