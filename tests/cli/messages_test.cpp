// Messages on stderr are whole, whatever happens.
#include <fmt/format.h>

#include <array>
#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>
#include <sstream>
#include <utility>
#include <vector>

#include "cli/cli_testing.hpp"

namespace elgen::test {

namespace {

/// Three commands with something to say, one without, and one that time ends.
constexpr std::array ends{
    std::pair{"elgen generate $broken/near_miss_name.toml $broken/unknown_unit.toml", 2},
    std::pair{"elgen generate -o /dev/null/out $models/simple_pendulum.toml", 4},
    std::pair{"elgen shwo", 2},
    std::pair{"elgen show $models/simple_pendulum.toml", 0},
    std::pair{"elgen verify --limit seconds=1 $models/panda7.toml", 3},
};

/// What stderr has: an object a line.
std::vector<nlohmann::json> messages_of(const std::string& errors) {
  std::vector<nlohmann::json> messages;
  std::istringstream lines(errors);
  for (std::string line; std::getline(lines, line);) {
    messages.push_back(nlohmann::json::parse(line));
  }
  return messages;
}

}  // namespace

TEST_CASE("every line is a message, with all that is said of all inputs") {
  const Workspace workspace;
  const std::string names = "models=" + models + " broken=" + broken + "; ";
  std::vector<std::vector<nlohmann::json>> said;
  for (const auto& [command, status] : ends) {
    INFO(command);
    const Outcome outcome = shell(names + command + " --format json", workspace.path());
    CHECK(outcome.status == status);
    said.push_back(messages_of(outcome.errors));
  }
  REQUIRE(said.at(0).size() == 2);
  CHECK(said.at(0).at(0).at("code") == "E201");
  CHECK(said.at(0).at(1).at("code") != "E201");
  CHECK(said.at(3).empty());
  CHECK(said.at(4).at(0).at("code") == "E909");
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
  const auto messages = messages_of(read_text(workspace.path() / "out"));
  REQUIRE_FALSE(messages.empty());
  CHECK(messages.back().at("code") == "E909");
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
  for (const std::string option : {"--timings", "-v", "--dump lower"}) {
    INFO(option);
    const Outcome outcome = shell(generate + "--format json " + option, workspace.path());
    CHECK(outcome.status == 2);
    CHECK(nlohmann::json::parse(outcome.errors).at("code") == "E913");
  }
}

}  // namespace elgen::test
