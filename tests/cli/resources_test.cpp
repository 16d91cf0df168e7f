// Limits on time and memory, and interrupts: the process ends in order, and nothing is left behind.
#include <catch2/catch.hpp>

#include "support/shell.hpp"

namespace elgen::test {

namespace {

/// A chain that takes several seconds to derive.
const std::string long_job = "elgen generate --limit derived_nodes=1000000000 --size n=400 " +
                             std::string(ELGEN_SOURCE_DIR) + "/models/chain.toml ";

}  // namespace

TEST_CASE("processor time that is used up ends with E909 and 3") {
  const Workspace workspace;
  const Outcome outcome = shell(long_job + "--limit seconds=1", workspace.path());
  CHECK(outcome.status == 3);
  CHECK(mentions(outcome.errors, "[E909]"));
  CHECK(shell("ls", workspace.path()).output.empty());
}

TEST_CASE("memory that is used up ends with E910 and 3") {
  const Workspace workspace;
  const Outcome outcome = shell(long_job + "--limit memory_mib=64", workspace.path());
  CHECK(outcome.status == 3);
  CHECK(mentions(outcome.errors, "[E910]"));
  CHECK(shell("ls", workspace.path()).output.empty());
}

TEST_CASE("an interrupt ends with 130") {
  const Workspace workspace;
  const Outcome outcome =
      shell("timeout --preserve-status -s INT 0.5 " + long_job, workspace.path());
  CHECK(outcome.status == 130);
  CHECK(shell("ls", workspace.path()).output.empty());
}

}  // namespace elgen::test
