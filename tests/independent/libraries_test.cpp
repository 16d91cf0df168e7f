// The independent programs against each other and against the reference values: what they are given
// describes the same robots.
#include <catch2/catch.hpp>

#include "independent/agreement.hpp"
#include "independent/reference_check.hpp"

namespace elgen::test {

namespace {

const std::filesystem::path tests = std::filesystem::path(ELGEN_SOURCE_DIR) / "tests";

std::vector<Robot> robots() {
  return {read_robot(tests / "reference/panda7.json"), read_robot(tests / "reference/ur5.json"),
          read_robot(tests / "independent/robots/torso.json")};
}

}  // namespace

TEST_CASE("KDL and MuJoCo agree") {
  for (const Robot& robot : robots()) {
    const Differences worst = differences(mujoco_oracle(robot), kdl_oracle(robot),
                                          random_states(robot.links.size(), false));
    INFO(robot.name << ": M " << worst.mass_matrix << ", bias " << worst.bias << ", torque "
                    << worst.torque);
    CHECK(worst.mass_matrix < agreed);
    CHECK(worst.bias < agreed);
    CHECK(worst.torque < agreed);
  }
}

TEST_CASE("KDL and MuJoCo give the reference values") {
  for (const Robot& robot : robots()) {
    if (!robot.reference) continue;
    INFO(robot.name);
    check_reference_values(kdl_oracle(robot), *robot.reference);
    check_reference_values(mujoco_oracle(robot), *robot.reference);
  }
}

}  // namespace elgen::test
