// Costs of generation, output by output.
#include <catch2/catch.hpp>

#include "cli/cli_testing.hpp"

namespace elgen::test {

namespace {

std::string costs(const std::string& input) {
  const Workspace workspace;
  const Outcome outcome =
      shell("elgen show -q --what cost " + models + "/" + input, workspace.path());
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
  CHECK(mentions(text, "\nmass_matrix              3  "));
  CHECK(mentions(text, "reaction                48           -"));
  CHECK(mentions(text, "ms, the full model in "));
}

TEST_CASE("a scene is compared with the full model of its own size") {
  const Workspace workspace;
  const std::string scene = "format = 1\nmodel = \"" + models + "/chain.toml\"\nname = \"long\"\n";
  write_text(workspace.path() / "long.scene.toml", scene + "[sizes]\nn = 4\n");
  write_text(workspace.path() / "same.scene.toml", scene);
  for (const std::string& command :
       {std::string("long.scene.toml"), std::string("same.scene.toml --size n=4"),
        std::string("long.scene.toml --size n=3")}) {
    INFO(command);
    const Outcome outcome = shell("elgen show -q --what cost " + command, workspace.path());
    CHECK(outcome.status == 0);
    // Nothing is fixed or locked: every output costs what it costs in the full model.
    CHECK(mentions(outcome.output, "   100 %"));
    const std::size_t row = outcome.output.find("\nmass_matrix ", outcome.output.find("\noutput "));
    REQUIRE(row != std::string::npos);
    CHECK(mentions(outcome.output.substr(row, 70), " 100 %"));
  }
}

}  // namespace elgen::test
