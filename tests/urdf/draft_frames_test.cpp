// draft_frames: origins, right angles, and the frame between origin and motion.
#include <catch2/catch.hpp>

#include "urdf/draft.hpp"
#include "urdf/urdf_testing.hpp"

namespace elgen::test {

using Catch::Contains;

TEST_CASE("a revolute joint is one frame: origin, constant turns z y x, then the angle") {
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

TEST_CASE("what slides or floats in turned axes has a frame for them") {
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

TEST_CASE("in axes that are not turned, the way is added to the origin") {
  CHECK_THAT(imported(arm_on("prismatic", "<origin xyz=\"1 0 0\"/>")),
             Contains("translate = [\"x_j + j\", \"0\", \"0\"]"));
}

TEST_CASE("an axis that was rounded is told") {
  CHECK_THAT(imported(arm_on("revolute", "<axis xyz=\"1e-9 0 1\"/>")),
             Contains("\n# j: revolute about z (in the URDF: 1e-9 0 1)\n[[frame]]"));
  CHECK_THAT(imported(arm_on("revolute", "<axis xyz=\"1 0 1\"/>")),
             Contains("\n# j: revolute about 1 0 1\n[[frame]]"));
}

TEST_CASE("constant turns without angle are left out") {
  const urdf::FileNumber zero;
  CHECK(urdf::steps_of(urdf::rotation_of({zero, zero, zero}, urdf::AngleDigits::rounded)).empty());
  CHECK(urdf::frame_comments("j", urdf::rotation_of({zero, zero, zero}, urdf::AngleDigits::rounded),
                             {})
            .size() == 1);
}

}  // namespace elgen::test
