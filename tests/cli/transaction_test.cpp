// Processes that write to the same folders take turns. What fails half-way: tests/faults.
#include <catch2/catch.hpp>

#include "cli/cli_testing.hpp"

namespace elgen::test {

TEST_CASE("a lock that is not released is waited for in vain") {
  const Workspace workspace;
  prepare("mkdir -p generated/cart_pole", workspace.path());
  const Outcome outcome = shell(
      "flock generated/cart_pole elgen generate -q --limit seconds=1 " + models + "/cart_pole.toml",
      workspace.path());
  CHECK(outcome.status == 4);
  CHECK(mentions(outcome.errors, "could not be written: another process writes there"));
  CHECK(files_below(workspace.path()).empty());
}

TEST_CASE("writers of two versions at once leave one of them, and make one folder together") {
  const Workspace workspace;
  prepare("cp " + models + "/cart_pole.toml a.toml && sed 's/\"-g\"/\"-2*g\"/' a.toml > b.toml",
          workspace.path());
  for (int round = 0; round < 10; ++round) {
    const Outcome outcome = shell(
        "rm -rf generated; elgen generate -q a.toml & elgen generate -q b.toml; b=$?; wait $! && "
        "test $b = 0 && { elgen generate -q --check a.toml || elgen generate -q --check b.toml; }",
        workspace.path());
    INFO(outcome.errors);
    CHECK(outcome.status == 0);
  }
}

}  // namespace elgen::test
