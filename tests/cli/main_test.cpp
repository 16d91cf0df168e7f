// The exit codes of the process are the interface.
#include <catch2/catch.hpp>

#include "support/shell.hpp"

namespace elgen::test {

TEST_CASE("each kind of end has its exit code") {
  const std::string models = std::string(ELGEN_SOURCE_DIR) + "/models";
  const Workspace workspace;
  const auto status = [&](const std::string& command) {
    return shell(command, workspace.path()).status;
  };
  const std::string generate = "elgen generate -q " + models + "/cart_pole.toml ";
  CHECK(status("elgen --help") == 0);
  CHECK(status(generate + "--check") == 1);
  CHECK(status("elgen generate") == 2);
  CHECK(status(generate + "--limit derived_nodes=3") == 3);
  CHECK(status(generate + "-o /dev/null/out") == 4);
  CHECK(status(generate) == 0);
  CHECK(status(generate + "--check") == 0);
}

}  // namespace elgen::test
