// elgen explain: every code of the table has its words.
#include <catch2/catch.hpp>

#include "elgen/diagnostic.hpp"
#include "support/shell.hpp"

namespace elgen::test {

namespace {

Outcome run(const std::string& command) {
  const Workspace workspace;
  return shell(command, workspace.path());
}

}  // namespace

TEST_CASE("explain knows every code") {
  for (const CodeRow& row : code_table()) {
    const Outcome outcome = run("elgen explain " + std::string(row.name));
    INFO(row.name);
    CHECK(outcome.status == 0);
    CHECK(mentions(outcome.output, std::string(row.title)));
  }
  const Outcome unknown = run("elgen explain E999");
  CHECK(unknown.status == 2);
  CHECK(unknown.output.empty());
}

}  // namespace elgen::test
