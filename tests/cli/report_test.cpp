// Everything for people: diagnostics as text and JSON, colour, silence, timings.
#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "support/shell.hpp"

namespace elgen::test {

namespace {

const std::string models = std::string(ELGEN_SOURCE_DIR) + "/models";
const std::string broken = std::string(ELGEN_SOURCE_DIR) + "/tests/errors/broken_models";

Outcome run(const std::string& command) {
  const Workspace workspace;
  return shell(command, workspace.path());
}

}  // namespace

TEST_CASE("a diagnostic as JSON is one line with code, place and message") {
  const Outcome outcome = run("elgen --format json generate " + broken + "/near_miss_name.toml");
  CHECK(outcome.status == 2);
  const nlohmann::json parsed = nlohmann::json::parse(outcome.errors);
  CHECK(parsed["code"] == "E201");
  CHECK(parsed["severity"] == "error");
  CHECK(parsed["position"]["line"] == 27);
  CHECK(parsed["position"]["column"] == 20);
}

TEST_CASE("colour on request, and never on a pipe without it") {
  const std::string command = "generate " + broken + "/near_miss_name.toml";
  CHECK(mentions(run("elgen --color always " + command).errors, "\x1b["));
  CHECK_FALSE(mentions(run("elgen --color auto " + command).errors, "\x1b["));
  CHECK_FALSE(mentions(run("elgen --color never " + command).errors, "\x1b["));
  CHECK_FALSE(mentions(run("elgen " + command).errors, "\x1b["));
}

TEST_CASE("-q leaves only errors") {
  const Outcome quiet = run("elgen generate -q " + models + "/cart_pole.toml");
  CHECK(quiet.status == 0);
  CHECK(quiet.output.empty());
  CHECK(quiet.errors.empty());
}

TEST_CASE("timings name every stage") {
  const Outcome outcome = run("elgen generate --timings " + models + "/simple_pendulum.toml");
  CHECK(outcome.status == 0);
  for (const char* stage : {"parse", "check", "formulate", "derive", "lower", "emit"}) {
    CHECK(mentions(outcome.errors, stage));
  }
}

}  // namespace elgen::test
