// Frames and bodies: origins, right angles, the frame between origin and motion; masses, centres of
// mass, and inertias in the axes of the link.
#include <catch2/catch.hpp>

#include "urdf/draft.hpp"
#include "urdf/urdf_testing.hpp"

namespace elgen::test {

using Catch::Contains;

namespace {

/// The model of the link `b`, which rotates about z and has this inertial.
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

TEST_CASE("a revolute joint is one frame: origin, constant rotations z y x, then the angle") {
  const std::string model = imported(arm_on(
      "revolute", "<origin xyz=\"1 0 2\" rpy=\"-1.57079632679 0 0.3\"/><axis xyz=\"0 1 0\"/>"));
  CHECK_THAT(model, Contains(R"(
# j: revolute about y
# rpy in the URDF: -1.57079632679 0 0.3
[[frame]]
name      = "arm"
parent    = "world"
translate = ["x_j", "0", "z_j"]
rotate    = [["z", "0.3"], ["x", "-pi/2"], ["y", "j"]]
)"));
}

TEST_CASE("a joint that slides or floats in rotated axes has a frame for them") {
  CHECK_THAT(imported(arm_on("prismatic",
                             "<origin xyz=\"0 0 1\" rpy=\"0 0.2 0\"/><axis xyz=\"0 0 -1\"/>")),
             Contains(R"(
# j: prismatic along -z
[[frame]]
name      = "j_origin"
parent    = "world"
translate = ["0", "0", "z_j"]
rotate    = [["y", "0.2"]]

[[frame]]
name      = "arm"
parent    = "j_origin"
translate = ["0", "0", "-j"]
)"));
  CHECK_THAT(imported(arm_on("floating", "<origin xyz=\"0 0 1\"/>")), !Contains("j_origin"));
  CHECK_THAT(imported(arm_on("floating", "<origin rpy=\"0 0 1\"/>")), Contains("j_origin"));
}

TEST_CASE("in axes that are not rotated, the displacement is added to the origin") {
  CHECK_THAT(imported(arm_on("prismatic", "<origin xyz=\"1 0 0\"/>")),
             Contains("translate = [\"x_j + j\", \"0\", \"0\"]"));
}

TEST_CASE("a rounded axis is named in a comment with its digits") {
  CHECK_THAT(imported(arm_on("revolute", "<axis xyz=\"1e-9 0 1\"/>")),
             Contains("\n# j: revolute about z (in the URDF: 1e-9 0 1)\n[[frame]]"));
  CHECK_THAT(imported(arm_on("revolute", "<axis xyz=\"1 0 1\"/>")),
             Contains("\n# j: revolute about 1 0 1\n[[frame]]"));
}

TEST_CASE("constant rotations by 0 are omitted") {
  const urdf::FileNumber zero;
  CHECK(urdf::turn_texts(urdf::round_rotation({zero, zero, zero}, urdf::AngleRounding::round))
            .empty());
  CHECK(urdf::frame_comments(
            "j", urdf::round_rotation({zero, zero, zero}, urdf::AngleRounding::round), {})
            .size() == 1);
}

TEST_CASE("the numbers of a body are parameters, and zeros stay zeros") {
  CHECK_THAT(model_with("<origin xyz=\"0 0.5 0\"/><mass value=\"4\"/>" + inertia("0")), Contains(R"(
[[body]]
name    = "b"
frame   = "b"
mass    = "m_b"
com     = ["0", "cy_b", "0"]
inertia = ["Ixx_b", "Iyy_b", "Izz_b"]
)"));
}

TEST_CASE("products of inertia give six numbers") {
  CHECK_THAT(model_with("<mass value=\"4\"/>" + inertia("0.1")),
             Contains("inertia = [\"Ixx_b\", \"Iyy_b\", \"Izz_b\",\n"
                      "           \"Ixy_b\", \"0\", \"0\"]\n"));
}

TEST_CASE("an inertia in axes rotated by right angles is converted to the link's axes") {
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

TEST_CASE("a mass without inertia is a point mass") {
  const std::string model = model_with(
      "<origin rpy=\"0 0 0.3\"/><mass value=\"4\"/><inertia ixx=\"0\" iyy=\"0\" izz=\"0\" "
      "ixy=\"0\" ixz=\"0\" iyz=\"0\"/>");
  CHECK_THAT(model, !Contains("b_inertial"));
  CHECK_THAT(model, !Contains("inertia ="));
  CHECK_THAT(model, Contains("mass  = \"m_b\""));
}

}  // namespace elgen::test
