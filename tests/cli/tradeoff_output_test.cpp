// Tables as they are printed and written, and the design that is chosen; no time is looked at.
#include <catch2/catch.hpp>

#include "cli/cli_testing.hpp"

namespace elgen::test {

TEST_CASE("a scene keeps what it locks and fixes, and files are not overwritten unasked") {
  const Workspace workspace;
  const std::string command =
      "elgen tradeoff -q --as csv -o x.csv " + models + "/scenes/balance.scene.toml";
  const Outcome outcome = shell(command, workspace.path());
  INFO(outcome.errors);
  CHECK(outcome.status == 0);
  CHECK(starts_with(outcome.output, "scalar,batch,"));
  CHECK(outcome.output == read_text(workspace.path() / "x.csv"));
  CHECK(shell(command, workspace.path()).status == 4);
  CHECK(shell("elgen tradeoff -o x.pdf " + models + "/cart_pole.toml", workspace.path()).status ==
        2);
}

TEST_CASE("where no design is good enough no scene is written, and the table all the same") {
  const Workspace workspace;
  const Outcome outcome =
      shell("elgen tradeoff --of gravity --max-error 1e-30 --write-scene x.scene.toml -o x.csv " +
                models + "/simple_pendulum.toml",
            workspace.path());
  CHECK(outcome.status == 1);
  CHECK(mentions(outcome.errors, "error[E632]: no design is within 1e-30\n"));
  CHECK(starts_with(read_text(workspace.path() / "x.csv"), "scalar,"));
  CHECK_FALSE(std::filesystem::exists(workspace.path() / "x.scene.toml"));
}

}  // namespace elgen::test
