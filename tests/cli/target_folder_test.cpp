// What changes in a folder, and what is left in it.
#include <catch2/catch.hpp>

#include "cli/cli_testing.hpp"

namespace elgen::test {

TEST_CASE("a file whose bytes do not change is not touched") {
  const Workspace workspace;
  prepare("cp " + models +
              "/cart_pole.toml . && elgen generate -q cart_pole.toml && cd generated/"
              "cart_pole && touch -d 2001-01-01 * && sed -i s/M/N/ cart_pole.md",
          workspace.path());
  const Outcome outcome = shell("elgen generate cart_pole.toml", workspace.path());
  CHECK(outcome.status == 0);
  CHECK(mentions(outcome.errors, "unchanged generated/cart_pole/cart_pole.hpp\n"));
  CHECK(mentions(outcome.errors, "wrote generated/cart_pole/cart_pole.md\n"));
  CHECK(shell("find generated -type f -newermt 2002-01-01", workspace.path()).output ==
        "generated/cart_pole/cart_pole.md\n");
}

TEST_CASE("what a killed process left is removed by the next one") {
  const Workspace workspace;
  write_text(workspace.path() / "generated/cart_pole/.elgen-stage-abcdef/new0", "half");
  CHECK(shell("elgen generate -q " + models + "/cart_pole.toml", workspace.path()).status == 0);
  CHECK(shell("ls -A generated/cart_pole", workspace.path()).output ==
        "cart_pole.equations.json\ncart_pole.hpp\ncart_pole.md\n");
}

}  // namespace elgen::test
