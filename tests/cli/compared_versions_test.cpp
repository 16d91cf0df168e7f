// What is found in folders, and what is left alone.
#include <catch2/catch.hpp>

#include "support/shell.hpp"

namespace elgen::test {

TEST_CASE("files of other programs, hidden folders and equal files are passed over") {
  const Workspace workspace;
  const std::string models = std::string(ELGEN_SOURCE_DIR) + "/models";
  prepare("mkdir -p old/.cache && cp " + models +
              "/simple_pendulum.toml old && "
              "cp old/simple_pendulum.toml old/.cache && echo '[tool]' > old/pyproject.toml && "
              "cp -r old new && echo 'x = 1' >> new/pyproject.toml && rm -r new/.cache",
          workspace.path());
  const Outcome outcome = shell("elgen diff old new", workspace.path());
  CHECK(outcome.status == 0);
  CHECK(outcome.output == "identical  nothing differs\n");
}

TEST_CASE("a folder is not compared with a file") {
  const Workspace workspace;
  const std::string models = std::string(ELGEN_SOURCE_DIR) + "/models";
  const Outcome outcome =
      shell("elgen diff " + models + " " + models + "/simple_pendulum.toml", workspace.path());
  CHECK(outcome.status == 4);
  CHECK(mentions(outcome.errors, "is a folder"));
}

}  // namespace elgen::test
