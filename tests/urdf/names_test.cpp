// Names of a URDF as names of a model.
#include "urdf/names.hpp"

#include <catch2/catch.hpp>

namespace elgen::test {

TEST_CASE("a name is letters, digits and single underscores") {
  CHECK(urdf::well_formed("panda_link1") == "panda_link1");
  CHECK(urdf::well_formed("left-leg.1") == "left_leg_1");
  CHECK(urdf::well_formed("a__b") == "a_b");
  CHECK(urdf::well_formed("_a_") == "a");
  CHECK(urdf::well_formed("1st link") == "n1st_link");
  CHECK(urdf::well_formed("\xC3\xA9") == "unnamed");
  CHECK(urdf::well_formed("") == "unnamed");
}

TEST_CASE("names are claimed once, and not from C++ or the language") {
  urdf::Names names;
  CHECK(names.claim("arm", "link") == "arm");
  CHECK(names.claim("arm", "link") == "link_arm");
  CHECK(names.claim("arm", "link") == "link_arm_2");
  CHECK(names.claim("union", "link") == "link_union");
  CHECK(names.claim("t", "joint") == "joint_t");
  CHECK(names.claim("INT_arm", "link") == "link_INT_arm");
  CHECK(names.claim("detail", "joint") == "joint_detail");
}

TEST_CASE("a model is called by its robot, in lower case") {
  CHECK(urdf::model_name("UR5 Robot") == "ur5_robot");
  CHECK(urdf::model_name("default") == "robot_default");
}

}  // namespace elgen::test
