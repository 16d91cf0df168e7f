#include <catch2/catch.hpp>

#include "cli/cli_testing.hpp"

using namespace elgen::test;

TEST_CASE("a shell without completions is refused") {
  const Outcome refused = run("elgen completions tcsh");
  CHECK(refused.status == 2);
  CHECK(refused.errors.find("see `elgen completions --help`") != std::string::npos);
}
