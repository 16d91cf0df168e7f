// Progress is shown on a terminal only, only after half a second, and leaves no trace.
#include <catch2/catch.hpp>

#include "cli/cli_testing.hpp"

namespace elgen::test {

namespace {

/// What a terminal receives.
std::string on_terminal(const std::string& command) {
  const Workspace workspace;
  return shell("script -q -e -c \"" + command + "\" /dev/null", workspace.path()).output;
}

}  // namespace

TEST_CASE("a long job names its input and stage on a terminal and clears the line") {
  const std::string seen =
      on_terminal("elgen generate -q --size n=20 -o out " + models + "/chain.toml");
  CHECK(mentions(seen, clear_line + models + "/chain.toml: "));
  REQUIRE(seen.size() >= clear_line.size());
  CHECK(seen.substr(seen.size() - clear_line.size()) == clear_line);
}

TEST_CASE("a short job shows no progress") {
  CHECK(on_terminal("elgen generate -q " + models + "/simple_pendulum.toml").empty());
}

TEST_CASE("a pipe is shown no progress") {
  const Workspace workspace;
  const Outcome outcome =
      shell("elgen generate -q --size n=20 -o out " + models + "/chain.toml", workspace.path());
  CHECK(outcome.errors.empty());
  CHECK(outcome.output.empty());
}

}  // namespace elgen::test
