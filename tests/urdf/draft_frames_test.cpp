// draft_frames: origins, right angles, and the frame between origin and motion.
#include <catch2/catch.hpp>

#include "urdf/drafting.hpp"
#include "urdf/urdf_testing.hpp"

namespace elgen::test {

namespace {

std::vector<urdf::FrameDraft> frames_of(const std::string& type, const std::string& elements) {
  const urdf::Robot robot = robot_of(arm_on(type, elements));
  return urdf::make_draft(robot, tree_of(robot)).links.back().frames;
}

std::string rotation_text(const urdf::FrameDraft& frame) {
  std::string text;
  for (const urdf::AxisAngle& step : frame.rotate) {
    text += (text.empty() ? "" : ", ") + step.axis[0] + " " + step.angle;
  }
  return text;
}

}  // namespace

TEST_CASE("a revolute joint is one frame: origin, constant turns z y x, then the angle") {
  const auto frames = frames_of(
      "revolute", "<origin xyz=\"1 0 2\" rpy=\"-1.57079632679 0 0.3\"/><axis xyz=\"0 1 0\"/>");
  REQUIRE(frames.size() == 1);
  CHECK(frames[0].name == "arm");
  CHECK(frames[0].parent == "world");
  CHECK(frames[0].translate == urdf::Components{"x_j", "0", "z_j"});
  CHECK(rotation_text(frames[0]) == "z 0.3, x -pi/2, y j");
  CHECK(frames[0].comments ==
        std::vector<std::string>{"j: revolute about y", "rpy in the URDF: -1.57079632679 0 0.3"});
}

TEST_CASE("what slides or floats in turned axes has a frame for them") {
  const auto sliding =
      frames_of("prismatic", "<origin xyz=\"0 0 1\" rpy=\"0 0.2 0\"/><axis xyz=\"0 0 -1\"/>");
  REQUIRE(sliding.size() == 2);
  CHECK(sliding[0].name == "j_origin");
  CHECK(sliding[0].translate == urdf::Components{"0", "0", "z_j"});
  CHECK(rotation_text(sliding[0]) == "y 0.2");
  CHECK(sliding[0].comments == std::vector<std::string>{"j: prismatic along -z"});
  CHECK(sliding[1].parent == "j_origin");
  CHECK(sliding[1].translate == urdf::Components{"0", "0", "-j"});
  CHECK(sliding[1].comments.empty());
  CHECK(frames_of("floating", "<origin xyz=\"0 0 1\"/>").size() == 1);
  CHECK(frames_of("floating", "<origin rpy=\"0 0 1\"/>").size() == 2);
}

TEST_CASE("in axes that are not turned, the way is added to the origin") {
  const auto frames = frames_of("prismatic", "<origin xyz=\"1 0 0\"/>");
  CHECK(frames[0].translate == urdf::Components{"x_j + j", "0", "0"});
}

TEST_CASE("an axis that was rounded is told") {
  CHECK(frames_of("revolute", "<axis xyz=\"1e-9 0 1\"/>")[0].comments ==
        std::vector<std::string>{"j: revolute about z (in the URDF: 1e-9 0 1)"});
  CHECK(frames_of("revolute", "<axis xyz=\"1 0 1\"/>")[0].comments ==
        std::vector<std::string>{"j: revolute about 1 0 1"});
}

TEST_CASE("constant turns without angle are left out") {
  const urdf::FileNumber zero;
  CHECK(urdf::steps_of(urdf::rotation_of({zero, zero, zero})).empty());
  CHECK(urdf::rounding_comment(urdf::rotation_of({zero, zero, zero}), {}).empty());
}

}  // namespace elgen::test
