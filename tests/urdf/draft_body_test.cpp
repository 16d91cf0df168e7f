// draft_body: masses, centres and inertias in the axes of the link.
#include <catch2/catch.hpp>

#include "urdf/draft.hpp"
#include "urdf/urdf_testing.hpp"

namespace elgen::test {

using Catch::Contains;

namespace {

/// The model of the link `b`, which turns about z, with this inertial.
std::string model_with(const std::string& inertial) {
  return imported("<robot name=\"r\"><link name=\"a\"/><link name=\"b\"><inertial>" + inertial +
                  "</inertial></link><joint name=\"j\" type=\"revolute\"><parent "
                  "link=\"a\"/><child link=\"b\"/><axis xyz=\"0 0 1\"/></joint></robot>");
}

std::string inertia(const std::string& off_diagonal) {
  return "<inertia ixx=\"1\" iyy=\"2\" izz=\"3\" ixy=\"" + off_diagonal +
         "\" ixz=\"0\" iyz=\"0\"/>";
}

}  // namespace

TEST_CASE("a body has its numbers as parameters, and zeros as zeros") {
  CHECK_THAT(model_with("<origin xyz=\"0 0.5 0\"/><mass value=\"4\"/>" + inertia("0")), Contains(R"(
[[body]]
name    = "b"
frame   = "b"
mass    = "m_b"
com     = ["0", "cy_b", "0"]
inertia = ["Ixx_b", "Iyy_b", "Izz_b"]
)"));
}

TEST_CASE("products of inertia make six") {
  CHECK_THAT(model_with("<mass value=\"4\"/>" + inertia("0.1")),
             Contains("inertia = [\"Ixx_b\", \"Iyy_b\", \"Izz_b\",\n"
                      "           \"Ixy_b\", \"0\", \"0\"]\n"));
}

TEST_CASE("an inertia in axes turned by right angles stays in the link's") {
  const std::string model =
      model_with("<origin rpy=\"0 0 1.5708\"/><mass value=\"4\"/>" + inertia("0"));
  CHECK_THAT(model, !Contains("b_inertial"));
  CHECK_THAT(model, Contains("# inertia turned from axes of rpy 0 0 1.5708\n[[body]]\n"));
}

TEST_CASE("an inertia in oblique axes has a frame of its own at the centre of mass") {
  CHECK_THAT(
      model_with("<origin xyz=\"1 0 0\" rpy=\"0 0 0.3\"/><mass value=\"4\"/>" + inertia("0")),
      Contains(R"(
# axes of the inertia of b
[[frame]]
name      = "b_inertial"
parent    = "b"
translate = ["cx_b", "0", "0"]
rotate    = [["z", "0.3"]]

[[body]]
name    = "b"
frame   = "b_inertial"
mass    = "m_b"
com     = ["0", "0", "0"]
)"));
}

TEST_CASE("a mass without inertia is a point") {
  const std::string model = model_with(
      "<origin rpy=\"0 0 0.3\"/><mass value=\"4\"/><inertia ixx=\"0\" iyy=\"0\" izz=\"0\" "
      "ixy=\"0\" ixz=\"0\" iyz=\"0\"/>");
  CHECK_THAT(model, !Contains("b_inertial"));
  CHECK_THAT(model, !Contains("inertia ="));
  CHECK_THAT(model, Contains("mass  = \"m_b\""));
}

}  // namespace elgen::test
