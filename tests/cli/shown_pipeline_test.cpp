// A command's pipeline: its progress is gone before its products are printed.
#include <catch2/catch.hpp>

#include "cli/cli_testing.hpp"

namespace elgen::test {

TEST_CASE("the line of progress is gone before anything else is printed") {
  const Workspace workspace;
  const std::string seen =
      shell("script -q -e -c \"elgen generate -q --timings --size n=20 -o out " + models +
                "/chain.toml\" /dev/null",
            workspace.path())
          .output;
  CHECK(mentions(seen, clear_line + "       parse"));
}

}  // namespace elgen::test
