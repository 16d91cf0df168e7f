// <joint>: every element it may have, and what is wrong with them.
#include <catch2/catch.hpp>

#include "urdf/urdf_testing.hpp"

namespace elgen::test {

namespace {

/// What is said of a joint of the type with these elements; they stand on line 5.
std::string said(const std::string& type, const std::string& elements) {
  return reading_messages(arm_on(type, elements));
}

}  // namespace

TEST_CASE("a joint is read whole") {
  const urdf::Robot robot = robot_of(arm_on(
      "prismatic",
      "<origin xyz=\"1 2 3\"/><axis xyz=\"0 0 1\"/><limit lower=\"-1\" upper=\"2\" effort=\"3\" "
      "velocity=\"4\"/><dynamics damping=\"5\" friction=\"6\"/><mimic joint=\"k\" offset=\"7\"/>"));
  const urdf::Joint& joint = robot.joints[0];
  CHECK(joint.type == urdf::JointType::prismatic);
  CHECK(joint.parent.text == "base");
  CHECK(joint.origin.xyz[2].text == "3");
  CHECK(joint.axis[2].text == "1");
  CHECK(joint.limit.lower->text == "-1");
  CHECK(joint.limit.upper->text == "2");
  CHECK(joint.limit.effort->text == "3");
  CHECK(joint.limit.velocity->text == "4");
  CHECK(joint.damping.text == "5");
  CHECK(joint.friction.text == "6");
  CHECK(joint.mimic->joint.text == "k");
  CHECK(joint.mimic->multiplier.text == "1");
  CHECK(joint.mimic->offset.text == "7");
}

TEST_CASE("without an axis, it is x, without dynamics, nothing brakes") {
  const urdf::Joint joint = robot_of(arm_on("revolute", "")).joints[0];
  CHECK(joint.axis[0].text == "1");
  CHECK(joint.axis[1].is_zero());
  CHECK(joint.damping.is_zero());
  CHECK_FALSE(joint.mimic);
}

TEST_CASE("a type that does not exist, and the one that was meant") {
  CHECK(said("revolut", "") ==
        "E806 4:25 `revolut` is no type of joint | did you mean `revolute`?\n");
  CHECK(said("ball", "") == "E806 4:25 `ball` is no type of joint\n");
}

TEST_CASE("type, parent and child are required") {
  CHECK(reading_messages("<robot name=\"r\">\n<joint name=\"j\"><parent/></joint></robot>") ==
        "E803 2:2 `<joint>` has no attribute `type`\n"
        "E803 2:2 `<joint>` has no element `child`\n"
        "E803 2:18 `<parent>` has no attribute `link`\n");
}

TEST_CASE("an axis has a direction, and a planar one is x, y or z") {
  CHECK(said("revolute", "<axis xyz=\"0 0.0 -0\"/>") == "E813 5:12 the axis has no direction\n");
  CHECK(said("fixed", "<axis xyz=\"0 0 0\"/>").empty());
  CHECK(said("floating", "<axis xyz=\"0 0 0\"/>").empty());
  CHECK(said("planar", "<axis xyz=\"1 1 0\"/>") ==
        "E108 5:12 a planar joint is imported only with an axis along x, y or z\n");
}

TEST_CASE("limits are in order, and not negative") {
  CHECK(said("revolute", "<limit lower=\"1\" upper=\"-1\" effort=\"-2\" velocity=\"-3\"/>") ==
        "E814 5:15 lower `1` is above upper `-1`\n"
        "E814 5:37 effort `-2` is negative\n"
        "E814 5:51 velocity `-3` is negative\n");
}

TEST_CASE("what a type has no use for is silent or noted") {
  CHECK(said("fixed", "<limit effort=\"1\"/><dynamics damping=\"1\"/>").empty());
  CHECK(said("floating", "<dynamics damping=\"1\"/>") ==
        "E815 5:2 `<dynamics>` in `<joint>` is not imported\n");
  CHECK(said("fixed", "<mimic joint=\"k\"/>") ==
        "E815 5:2 `<mimic>` in a fixed `<joint>` is not imported | the joint has no coordinate\n");
  CHECK(said("revolute", "<calibration rising=\"0\"/><safety_controller k=\"1\"/>").empty());
  CHECK(said("revolute", "<spring stiffness=\"1\"/>") ==
        "E815 5:2 `<spring>` in `<joint>` is not imported\n");
}

TEST_CASE("every type has its word, and some have one coordinate") {
  CHECK(urdf::word(urdf::JointType::planar) == "planar");
  CHECK(urdf::has_one_coordinate(urdf::JointType::continuous));
  CHECK_FALSE(urdf::has_one_coordinate(urdf::JointType::floating));
}

}  // namespace elgen::test
