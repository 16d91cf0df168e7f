// Costs of generation, output by output.
#include <catch2/catch.hpp>

#include "support/shell.hpp"

namespace elgen::test {

namespace {

const std::string models = std::string(ELGEN_SOURCE_DIR) + "/models/";

std::string costs(const std::string& input) {
  const Workspace workspace;
  const Outcome outcome = shell("elgen show -q --what cost " + models + input, workspace.path());
  CHECK(outcome.status == 0);
  return outcome.output;
}

}  // namespace

TEST_CASE("a model's outputs have a cost and a time") {
  const std::string text = costs("simple_pendulum.toml");
  CHECK(mentions(text, "\noutput "));
  CHECK(mentions(text, "cost         alone\n"));
  CHECK(mentions(text, "\ngenerated in "));
  CHECK_FALSE(mentions(text, "full model"));
}

TEST_CASE("a scene is compared with its full model") {
  const std::string text = costs("scenes/two_link_arm_elbow.scene.toml");
  CHECK(mentions(text, "cost  full model   share"));
  // One entry of four: 3 operations instead of 10 and a sine with its cosine.
  CHECK(mentions(text, "\nmass_matrix              3"));
  CHECK(mentions(text, "reaction                49           -"));
  CHECK(mentions(text, "ms, the full model in "));
}

}  // namespace elgen::test
