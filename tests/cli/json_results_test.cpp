// With --format json every command prints only JSON or refuses.
#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>
#include <set>

#include "cli/cli_testing.hpp"

namespace elgen::test {

namespace {

const std::string pendulum = std::string(ELGEN_SOURCE_DIR) + "/models/simple_pendulum.toml";

struct JsonRow {
  std::string command;
  std::string line;  ///< the whole command line
  std::string key;   ///< a key of the object; empty: the result is a list
};

const std::vector<JsonRow> json_rows{
    {"generate", "generate --format json -o out " + pendulum, "systems"},
    {"generate", "generate --format json --list-outputs " + pendulum, "systems"},
    {"show", "show --format json " + pendulum, "outputs"},
    {"verify", "verify --format json --quick " + pendulum, "checks"},
    {"diff", "diff --format json " + pendulum + " " + pendulum, "systems"},
    {"evaluate", "evaluate --format json " + pendulum, "values"},
    {"vectors", "vectors --format json --samples 1 " + pendulum, "values"},
    {"simulate", "simulate --format json --time 0.1 " + pendulum, "rows"},
    {"tradeoff", "tradeoff --format json --trajectory 0.1 " + pendulum, "designs"},
    {"import", "import --format json -q -o gripper.toml " + robot, "files"},
    {"explain", "explain --format json E201", "code"},
    {"explain", "explain --format json coordinate", ""},
    {"schema", "schema --format json model", "properties"},
};

const std::vector<std::string> refused{
    "generate --format json --stdout " + pendulum,
    "show --format json --what steps " + pendulum,
    "import --format json " + robot,
    "completions --format json bash",
    "man --format json",
};

}  // namespace

TEST_CASE("every command prints its result as JSON or refuses") {
  std::set<std::string> said;
  const Workspace workspace;
  for (const JsonRow& row : json_rows) {
    INFO(row.line);
    said.insert(row.command);
    const Outcome outcome = workspace.run("elgen " + row.line);
    CHECK(outcome.status == 0);
    CHECK(outcome.errors.empty());
    const auto json = nlohmann::json::parse(outcome.output);
    CHECK((row.key.empty() ? json.is_array() : json.contains(row.key)));
  }
  for (const std::string& line : refused) said.insert(line.substr(0, line.find(' ')));
  for (const std::string name : {
#define ELGEN_COMMAND(name) #name,
#include "cli/commands.def"
#undef ELGEN_COMMAND
       }) {
    INFO(name);
    CHECK(said.count(name) == 1);
  }
}

TEST_CASE("options without JSON output are refused, with an error in JSON") {
  const Workspace workspace;
  for (const std::string& line : refused) {
    INFO(line);
    const Outcome outcome = workspace.run("elgen " + line);
    CHECK(outcome.status == 2);
    CHECK(outcome.output.empty());
    CHECK(nlohmann::json::parse(outcome.errors).at("code") == "E913");
  }
}

TEST_CASE("a generated system lists its files and marks new files") {
  const Workspace workspace;
  const std::string generate = "elgen generate --format json -o out " + pendulum;
  const auto system = [&] {
    return nlohmann::json::parse(workspace.run(generate).output).at("systems").at(0);
  };
  const auto first = system();
  CHECK(first.at("name") == "simple_pendulum");
  CHECK(first.at("input") == pendulum);
  REQUIRE(first.at("files").size() == 3);
  CHECK(first.at("files").at(1) ==
        nlohmann::json{{"path", "out/simple_pendulum/simple_pendulum.hpp"}, {"written", true}});
  CHECK(first.contains("self_check"));
  CHECK(system().at("files").at(1).at("written") == false);
}

TEST_CASE("JSON has the rows of a run, at the interval of --every") {
  const Workspace workspace;
  const std::string simulate = "elgen simulate --time 1 --every 0.5 " + pendulum;
  const auto run = nlohmann::json::parse(workspace.run(simulate + " --format json").output);
  CHECK(run.at("rows").size() == 3);
  const Outcome lost = workspace.run(simulate);
  CHECK(lost.status == 2);
  CHECK(mentions(lost.errors, "`--every` applies to rows"));
}

TEST_CASE("option --as sets the format of the result, whatever the format of messages") {
  const Workspace workspace;
  const std::string show = "elgen show --what gravity " + pendulum;
  CHECK(workspace.run(show + " --as text --format json").output == workspace.run(show).output);
  CHECK(starts_with(
      workspace.run("elgen tradeoff --trajectory 0.1 --as csv --format json " + pendulum).output,
      "method,"));
}

}  // namespace elgen::test
