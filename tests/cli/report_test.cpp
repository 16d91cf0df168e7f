// Everything for people: diagnostics as text and JSON, colour, silence, timings.
#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "cli/cli_testing.hpp"

namespace elgen::test {

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

TEST_CASE("option -q leaves only errors") {
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

TEST_CASE("option -q leaves out notes") {
  CHECK(mentions(run("elgen import " + robot).errors, "note[E815]"));
  CHECK(run("elgen import -q " + robot).errors.empty());
}

TEST_CASE("what cannot be printed is said, and ends with 4") {
  const std::string model = models + "/simple_pendulum.toml";
  for (const std::string& command :
       {"show " + model, "generate --stdout " + model, "generate --list-outputs " + model,
        "verify --quick " + model, "import " + robot, std::string("explain E201"),
        std::string("--help"), std::string("--version"), std::string("--limits")}) {
    INFO(command);
    const Outcome outcome = run("elgen " + command + " > /dev/full");
    CHECK(outcome.status == 4);
    CHECK(mentions(outcome.errors, "error[E706]: standard output could not be written\n"));
  }
}

TEST_CASE("a command line that is not understood is reported in the format asked for") {
  const nlohmann::json parsed = nlohmann::json::parse(run("elgen generte --format json").errors);
  CHECK(parsed["code"] == "E913");
  CHECK(mentions(run("elgen --color=always generte").errors, "\x1b["));
}

}  // namespace elgen::test
