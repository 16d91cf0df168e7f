// The command line: help, version, limits, explanations, exit codes, formats of diagnostics.
#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "elgen/diagnostic.hpp"
#include "elgen/limits.hpp"
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

TEST_CASE("help starts with three examples and names what there is, and only that") {
  const Outcome outcome = run("elgen --help");
  CHECK(outcome.status == 0);
  std::size_t examples = 0;
  const std::string head = outcome.output.substr(0, outcome.output.find("Usage"));
  for (std::size_t at = head.find("  elgen "); at != std::string::npos;
       at = head.find("  elgen ", at + 1)) {
    ++examples;
  }
  CHECK(examples == 3);
  for (const char* command : {"generate", "verify", "explain"}) {
    CHECK(mentions(outcome.output, command));
  }
  for (const char* later : {"simulate", "tradeoff", "import", "sarif"}) {
    CHECK_FALSE(mentions(outcome.output, later));
  }
}

TEST_CASE("version and limits are printed on stdout") {
  CHECK(run("elgen --version").output == "elgen 0.1.0\n");
  const Outcome limits = run("elgen --limits");
  CHECK(limits.status == 0);
  for (const LimitRow& row : limit_table()) CHECK(mentions(limits.output, std::string(row.name)));
}

TEST_CASE("a command line that is not understood exits with 2") {
  for (const char* line :
       {"elgen", "elgen generte x.toml", "elgen generate", "elgen generate --outptus x a.toml",
        "elgen --limit seconds=soon generate a.toml", "elgen --limit apples=3 generate a.toml"}) {
    INFO(line);
    const Outcome outcome = run(line);
    CHECK(outcome.status == 2);
    CHECK(outcome.output.empty());
    CHECK_FALSE(outcome.errors.empty());
  }
  CHECK(mentions(run("elgen generte x.toml").errors, "did you mean `generate`"));
}

TEST_CASE("diagnostics as JSON carry code, place and message") {
  const Outcome outcome = run("elgen --format json generate " + broken + "/near_miss_name.toml");
  CHECK(outcome.status == 2);
  const nlohmann::json parsed = nlohmann::json::parse(outcome.errors);
  REQUIRE(parsed.is_array());
  REQUIRE(parsed.size() == 1);
  CHECK(parsed[0]["code"] == "E201");
  CHECK(parsed[0]["line"] == 27);
  CHECK(parsed[0]["column"] == 20);
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

TEST_CASE("every stage can be dumped, and stopping there writes nothing") {
  for (const char* stage :
       {"parse", "check", "formulate", "specialise", "derive", "lower", "emit"}) {
    INFO(stage);
    const Workspace workspace;
    const Outcome outcome = shell("elgen generate --dump " + std::string(stage) + " --stop-after " +
                                      stage + " " + models + "/simple_pendulum.toml",
                                  workspace.path());
    CHECK(outcome.status == 0);
    CHECK(mentions(outcome.output, "theta"));
    CHECK(shell("ls", workspace.path()).output.empty());
  }
  CHECK(run("elgen generate --dump nowhere " + models + "/simple_pendulum.toml").status == 2);
}

TEST_CASE("timings name every stage") {
  const Outcome outcome = run("elgen generate --timings " + models + "/simple_pendulum.toml");
  CHECK(outcome.status == 0);
  for (const char* stage : {"parse", "check", "formulate", "derive", "lower", "emit"}) {
    CHECK(mentions(outcome.errors, stage));
  }
}

TEST_CASE("verify: all closed forms of the models hold, a wrong one exits with 1") {
  const Workspace workspace;
  const Outcome good = shell("elgen verify --quick " + models + "/*.toml", workspace.path());
  INFO(good.output + good.errors);
  CHECK(good.status == 0);
  prepare("sed 's/\"m\\*g\\*l\\*sin(theta)\"/\"m*g*l*cos(theta)\"/' " + models +
              "/simple_pendulum.toml > wrong.toml",
          workspace.path());
  const Outcome wrong = shell("elgen verify --quick wrong.toml", workspace.path());
  CHECK(wrong.status == 1);
  CHECK(mentions(wrong.errors, "[E510]"));
}

}  // namespace elgen::test
