#include <catch2/catch.hpp>

#include "cli/cli_testing.hpp"

using namespace elgen::test;

TEST_CASE("the list of commands has what --help has") {
  const std::string manual = run("elgen man").output;
  const std::string help = run("elgen --help").output;
  const std::size_t commands = help.find("Subcommands:");
  REQUIRE(commands != std::string::npos);
  std::istringstream lines(help.substr(help.find('\n', commands) + 1));
  int count = 0;
  for (std::string line; std::getline(lines, line) && line.starts_with("  ");) {
    if (line[2] == ' ') continue;  // a description that goes on
    const std::string name = line.substr(2, line.find(' ', 2) - 2);
    INFO(name);
    CHECK(manual.find("\n.SS " + name + "\n") != std::string::npos);
    ++count;
  }
  CHECK(count >= 9);
}
