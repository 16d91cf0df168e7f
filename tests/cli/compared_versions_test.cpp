// What is found in folders, and what is left alone.
#include <catch2/catch.hpp>

#include "cli/cli_testing.hpp"

namespace elgen::test {

TEST_CASE("files of other programs, hidden folders and equal files are passed over") {
  const Workspace workspace;
  prepare("mkdir -p old/.cache && cp " + models +
              "/simple_pendulum.toml old && "
              "cp old/simple_pendulum.toml old/.cache && echo '[tool]' > old/pyproject.toml && "
              "cp -r old new && echo 'x = 1' >> new/pyproject.toml && rm -r new/.cache",
          workspace.path());
  const Outcome outcome = shell("elgen diff old new", workspace.path());
  CHECK(outcome.status == 0);
  CHECK(outcome.output == "equal        the equations are the same\n");
}

TEST_CASE("a folder is not compared with a file") {
  const Workspace workspace;
  const Outcome outcome =
      shell("elgen diff " + models + " " + models + "/simple_pendulum.toml", workspace.path());
  CHECK(outcome.status == 4);
  CHECK(mentions(outcome.errors, "is a folder"));
}

TEST_CASE("steps are compared as they are emitted") {
  const Workspace workspace;
  prepare("cp -r " + models +
              " old && cp -r old new && "
              "sed -i 's/\"-g\"/\"g\"/' new/cart_pole.toml",
          workspace.path());
  const std::string scene = "scenes/cart_pole_prediction.scene.toml";
  const Outcome outcome =
      shell("elgen diff --list old/" + scene + " new/" + scene, workspace.path());
  CHECK(mentions(outcome.output, "step.rates[2] "));
}

}  // namespace elgen::test
