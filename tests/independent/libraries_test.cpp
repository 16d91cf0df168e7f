// Compares the independent programs with each other and with the reference values. Equal values
// show that the programs compute the same robots.
#include <catch2/catch.hpp>

#include "independent/agreement.hpp"
#include "independent/checks.hpp"

namespace elgen::test {

namespace {

const std::filesystem::path tests = std::filesystem::path(ELGEN_SOURCE_DIR) / "tests";

const std::vector<std::filesystem::path> robots{tests / "reference/panda7.json",
                                                tests / "reference/ur5.json",
                                                tests / "independent/robots/torso.json"};

}  // namespace

TEST_CASE("KDL and MuJoCo agree") {
  for (const std::filesystem::path& path : robots) {
    INFO(path.stem());
    check_agreement(mujoco_oracle(path, false), kdl_oracle(path, false),
                    random_states(read_robot(path).links.size(), false), agreement_tolerance);
  }
}

TEST_CASE("KDL and MuJoCo give the reference values") {
  for (const std::filesystem::path& path : robots) {
    const Robot robot = read_robot(path);
    if (!robot.reference) continue;
    INFO(robot.name);
    check_reference_values(kdl_oracle(path, false), *robot.reference);
    check_reference_values(mujoco_oracle(path, false), *robot.reference);
  }
}

}  // namespace elgen::test
