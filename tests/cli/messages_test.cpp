// What is said on stderr is one document from the first diagnostic to the last, whatever happens.
#include <fmt/format.h>

#include <array>
#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>
#include <sstream>
#include <utility>

#include "cli/cli_testing.hpp"
#include "cli/judged.hpp"

namespace elgen::test {

namespace {

/// Two commands with something to say, one without, and one that time ends.
constexpr std::array ends{
    std::pair{"elgen generate $broken/near_miss_name.toml $broken/unknown_unit.toml", 2},
    std::pair{"elgen generate -o /dev/null/out $models/simple_pendulum.toml", 4},
    std::pair{"elgen shwo", 2},
    std::pair{"elgen show $models/simple_pendulum.toml", 0},
    std::pair{"elgen verify --limit seconds=1 $models/panda7.toml", 3},
};

/// What SARIF 2.1.0 and those who show it require of a log; not all of its own schema.
constexpr const char* sarif_schema = R"({
  "type": "object", "required": ["version", "runs"],
  "properties": {
    "version": {"const": "2.1.0"},
    "runs": {"minItems": 1, "maxItems": 1, "items": {
      "required": ["tool", "results", "columnKind"],
      "properties": {
        "tool": {"required": ["driver"], "properties": {"driver": {
          "required": ["name", "version", "rules"],
          "properties": {"rules": {"items": {
            "required": ["id", "shortDescription", "fullDescription", "defaultConfiguration"]}}}}}},
        "results": {"items": {
          "required": ["ruleId", "ruleIndex", "level", "message", "locations", "partialFingerprints"],
          "properties": {
            "level": {"enum": ["none", "note", "warning", "error"]},
            "message": {"required": ["text"]},
            "locations": {"minItems": 1, "maxItems": 1, "items": {"properties": {
              "physicalLocation": {
                "required": ["artifactLocation", "region"],
                "properties": {
                  "artifactLocation": {"required": ["uri"]},
                  "region": {
                    "required": ["startLine", "startColumn", "endLine", "endColumn"],
                    "additionalProperties": {"type": "integer", "minimum": 1}}}}}}}}}}}}}}})";

/// What GitLab says of a report of code quality.
constexpr const char* gitlab_schema = R"({
  "type": "array", "items": {
    "required": ["description", "check_name", "fingerprint", "severity", "location"],
    "properties": {
      "severity": {"enum": ["info", "minor", "major", "critical", "blocker"]},
      "location": {"required": ["path", "lines"], "properties": {
        "path": {"type": "string", "not": {"pattern": "^\\./"}},
        "lines": {"required": ["begin"]}}}}}})";

/// stderr of all commands, each in a file that is judged; the workspace keeps these.
void run_all(const Judged& workspace, const std::string& format) {
  const std::string names = "models=" + models + " broken=" + broken + "; ";
  for (std::size_t i = 0; i < ends.size(); ++i) {
    const auto& [command, status] = ends.at(i);
    const std::string file = std::to_string(i) + ".json";
    INFO(command);
    CHECK(shell(names + command + " --format " + format + " 2> " + file, workspace.path()).status ==
          status);
    workspace.accepts(file);
  }
}

nlohmann::json read_json(const Workspace& workspace, const std::string& name) {
  return nlohmann::json::parse(read_text(workspace.path() / name));
}

}  // namespace

TEST_CASE("a log of SARIF is whole, with all that is said of all inputs") {
  const Judged workspace(sarif_schema);
  run_all(workspace, "sarif");
  const auto results = read_json(workspace, "0.json").at("runs").at(0).at("results");
  REQUIRE(results.size() == 2);
  CHECK(results.at(0).at("ruleId") == "E201");
  CHECK(results.at(1).at("ruleId") != "E201");
  CHECK(read_json(workspace, "3.json").at("runs").at(0).at("results").empty());
  CHECK(read_json(workspace, "4.json").at("runs").at(0).at("results").at(0).at("ruleId") == "E909");
}

TEST_CASE("a report of code quality is one list") {
  const Judged workspace(gitlab_schema);
  run_all(workspace, "gitlab");
  CHECK(read_json(workspace, "0.json").size() == 2);
  CHECK(read_json(workspace, "3.json").empty());
  CHECK(read_json(workspace, "4.json").at(0).at("check_name") == "E909");
}

TEST_CASE("a limit that is met while a message is written is told behind it") {
  // More than a pipe holds, so that the program waits in the middle of it.
  std::string text =
      "format = 1\n[model]\nname = \"m\"\n[[coordinate]]\nname = \"q\"\nunit = \"1\"\n[define]\n";
  for (int i = 0; i < 600; ++i) text += fmt::format("d{0} = \"nothing{0}*q + other{0}\"\n", i);
  const Workspace workspace;
  write_text(workspace.path() / "m.toml", text + "[energy]\nT = \"dot(q)^2\"\n");
  prepare(
      "mkfifo pipe && { elgen show --format json m.toml 2> pipe & echo $! > id; } && "
      "exec 3< pipe && sleep 0.5 && kill -XCPU $(cat id) && cat <&3 > out",
      workspace.path());
  std::istringstream lines(read_text(workspace.path() / "out"));
  std::string code;
  for (std::string line; std::getline(lines, line);) {
    const nlohmann::json message = nlohmann::json::parse(line, nullptr, false);
    REQUIRE_FALSE(message.is_discarded());
    code = message.at("code");
  }
  CHECK(code == "E909");
}

TEST_CASE("commands of a workflow stand among what people read") {
  const Workspace workspace;
  prepare("cp " + broken + "/near_miss_name.toml m.toml", workspace.path());
  const Outcome outcome = shell("elgen show --format github m.toml", workspace.path());
  CHECK(outcome.status == 2);
  CHECK(
      starts_with(outcome.errors, "::error file=m.toml,line=27,col=20,title=E201 unknown name::"));
  CHECK(mentions(
      shell("elgen generate --format github " + models + "/simple_pendulum.toml", workspace.path())
          .errors,
      "wrote generated/simple_pendulum/simple_pendulum.hpp\n"));
}

TEST_CASE("programs that read all are told nothing else, and what is for people is refused") {
  const Workspace workspace;
  const std::string generate = "elgen generate " + models + "/simple_pendulum.toml ";
  CHECK(shell(generate + "--format json", workspace.path()).errors.empty());
  for (const std::string option : {"--timings", "-v", "--dump parse"}) {
    INFO(option);
    const Outcome outcome = shell(generate + "--format json " + option, workspace.path());
    CHECK(outcome.status == 2);
    CHECK(nlohmann::json::parse(outcome.errors).at("code") == "E913");
  }
}

}  // namespace elgen::test
