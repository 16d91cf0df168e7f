// Output for people and programs: complete diagnostics as text and JSON in every case, colour, -q,
// timings, progress on a terminal.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <catch2/catch.hpp>
#include <csignal>
#include <nlohmann/json.hpp>
#include <utility>
#include <vector>

#include "cli/cli_testing.hpp"

namespace elgen::test {
namespace {

/// Three commands with errors, a command without messages, and a command ended by the time limit.
constexpr std::array end_rows{
    std::pair{"elgen generate $broken/near_miss_name.toml $broken/unknown_unit.toml", 2},
    std::pair{"elgen generate -o /dev/null/out $models/simple_pendulum.toml", 4},
    std::pair{"elgen shwo", 2},
    std::pair{"elgen show $models/simple_pendulum.toml", 0},
    std::pair{"elgen verify --limit seconds=1 $models/panda7.toml", 3},
};

/// The JSON objects on stderr, one per line.
std::vector<nlohmann::json> messages_of(const std::string& errors) {
  std::vector<nlohmann::json> messages;
  for (const std::string& line : split_lines(errors)) {
    messages.push_back(nlohmann::json::parse(line));
  }
  return messages;
}

/// The bytes that a terminal receives from `command`.
std::string run_on_terminal(const std::string& command) {
  const Workspace workspace;
  return workspace.run("script -q -e -c \"" + command + "\" /dev/null").output;
}

/// The output of `show` on a terminal of 60 columns.
std::string show_on_terminal(const std::string& environment) {
  const std::string command = "stty cols 60; " + environment + " " + std::string(ELGEN_BINARY) +
                              " show " + models + "/cart_pole.toml --what mass_matrix";
  return run("script -qc '" + command + "' /dev/null").output;
}

}  // namespace

TEST_CASE("a diagnostic as JSON is one line with code, position and message") {
  const Outcome outcome = run("elgen --format json generate " + broken + "/near_miss_name.toml");
  CHECK(outcome.status == 2);
  const nlohmann::json parsed = nlohmann::json::parse(outcome.errors);
  CHECK(parsed["code"] == "E201");
  CHECK(parsed["severity"] == "error");
  CHECK(parsed["position"]["line"] == 27);
  CHECK(parsed["position"]["column"] == 20);
}

TEST_CASE("colour on request only, if the output is a pipe") {
  const std::string command = "generate " + broken + "/near_miss_name.toml";
  CHECK(mentions(run("elgen --color always " + command).errors, "\x1b["));
  CHECK_FALSE(mentions(run("elgen --color auto " + command).errors, "\x1b["));
  CHECK_FALSE(mentions(run("elgen --color never " + command).errors, "\x1b["));
  CHECK_FALSE(mentions(run("elgen " + command).errors, "\x1b["));
}

TEST_CASE("option -q prints only errors") {
  const Outcome quiet = run("elgen generate -q " + models + "/cart_pole.toml");
  CHECK(quiet.status == 0);
  CHECK(quiet.output.empty());
  CHECK(quiet.errors.empty());
}

TEST_CASE("the thread that shows the stages leaves all signals to the first thread") {
  const Workspace workspace;
  const std::string command =
      "elgen generate -q --size n=397 --limit derived_nodes=1000000000 " + models + "/chain.toml";
  const Outcome outcome =
      workspace.run("timeout 60 script -q -c \"" + command +
                    "\" /dev/null > /dev/null &\n"
                    "for i in $(seq 50); do\n"
                    "  pid=$(pgrep -f '^[^ ]*elgen generate -q --size n=397') && break; sleep 0.1\n"
                    "done\n"
                    "sleep 0.2; grep -h SigBlk /proc/$pid/task/*/status; kill $pid");
  const std::vector<std::string> masks = split_lines(outcome.output);
  REQUIRE(masks.size() == 2);
  const auto blocks_end_of_child = [](const std::string& line) {
    constexpr unsigned long long child_bit = 1ULL << (SIGCHLD - 1);
    return (std::stoull(line.substr(line.find('\t') + 1), nullptr, 16) & child_bit) != 0;
  };
  CHECK(std::ranges::count_if(masks, blocks_end_of_child) == 1);
}

TEST_CASE("timings name every stage") {
  const Outcome outcome = run("elgen generate --timings " + models + "/simple_pendulum.toml");
  CHECK(outcome.status == 0);
  for (const char* stage : {"parse", "check", "formulate", "derive", "lower", "emit"}) {
    CHECK(mentions(outcome.errors, stage));
  }
}

TEST_CASE("option -q omits notes") {
  CHECK(mentions(run("elgen import " + robot).errors, "note[E815]"));
  CHECK(run("elgen import -q " + robot).errors.empty());
}

TEST_CASE("a failure to write standard output is reported and exits with 4") {
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

TEST_CASE("errors of the command line are reported in the requested format") {
  const nlohmann::json parsed = nlohmann::json::parse(run("elgen generte --format json").errors);
  CHECK(parsed["code"] == "E913");
  CHECK(mentions(run("elgen --color=always generte").errors, "\x1b["));
}

TEST_CASE("every line of stderr is a message, and all inputs are reported") {
  const Workspace workspace;
  const std::string names = "models=" + models + " broken=" + broken + "; ";
  std::vector<std::vector<nlohmann::json>> said;
  for (const auto& [command, status] : end_rows) {
    INFO(command);
    const Outcome outcome = workspace.run(names + command + " --format json");
    CHECK(outcome.status == status);
    said.push_back(messages_of(outcome.errors));
  }
  REQUIRE(said.at(0).size() == 2);
  CHECK(said.at(0).at(0).at("code") == "E201");
  CHECK(said.at(0).at(1).at("code") != "E201");
  CHECK(said.at(3).empty());
  CHECK(said.at(4).at(0).at("code") == "E909");
}

TEST_CASE("a limit that is exceeded while a message is written is reported after the message") {
  // The message is longer than a pipe holds, so the program waits while writing it.
  std::string text =
      "format = 1\n[model]\nname = \"m\"\n[[coordinate]]\nname = \"q\"\nunit = \"1\"\n[define]\n";
  for (int i = 0; i < 600; ++i) text += fmt::format("d{0} = \"nothing{0}*q + other{0}\"\n", i);
  const Workspace workspace;
  workspace.write("m.toml", text + "[energy]\nT = \"dot(q)^2\"\n");
  workspace.prepare(
      "mkfifo pipe && { elgen show --format json m.toml 2> pipe & echo $! > id; } && "
      "exec 3< pipe && sleep 0.5 && kill -XCPU $(cat id) && cat <&3 > out");
  const auto messages = messages_of(workspace.read("out"));
  REQUIRE_FALSE(messages.empty());
  CHECK(messages.back().at("code") == "E909");
}

TEST_CASE("workflow commands appear among the lines for people") {
  const Workspace workspace;
  workspace.prepare("cp " + broken + "/near_miss_name.toml m.toml");
  const Outcome outcome = workspace.run("elgen show --format github m.toml");
  CHECK(outcome.status == 2);
  CHECK(
      starts_with(outcome.errors, "::error file=m.toml,line=27,col=20,title=E201 unknown name::"));
  CHECK(mentions(
      workspace.run("elgen generate --format github " + models + "/simple_pendulum.toml").errors,
      "wrote generated/simple_pendulum/simple_pendulum.hpp\n"));
}

TEST_CASE(
    "characters that change the text direction are escaped in messages, annotations and JSON") {
  const std::string turn = "\u202E";
  const Workspace workspace;
  workspace.prepare("cp " + models + "/simple_pendulum.toml 'a" + turn + ".toml'");
  const std::string file = "'a" + turn + ".toml' ";
  for (const std::string& command :
       {"elgen show 'b" + turn + ".toml'", "elgen show --what 'x" + turn + "' " + file,
        "elgen show --bad" + turn, "elgen generate --fix 'm" + turn + "' -o out " + file,
        "elgen simulate --time 1 --set 'm" + turn + "=1' " + file, "elgen generate " + file}) {
    for (const std::string format : {"text", "json", "github"}) {
      const Outcome outcome = workspace.run(command + " --format " + format);
      INFO(command + format + outcome.errors);
      CHECK_FALSE((outcome.output.empty() && outcome.errors.empty()));
      CHECK_FALSE(mentions(outcome.output, turn));
      CHECK_FALSE(mentions(outcome.errors, turn));
    }
  }
  const Outcome listed = workspace.run("elgen generate --format json " + file);
  const auto system = nlohmann::json::parse(listed.output)["systems"][0];
  CHECK(system["input"] == "a" + turn + ".toml");
  const std::string folder = "generated/simple_pendulum/simple_pendulum.";
  for (const std::string ending : {"hpp", "md", "equations.json"}) {
    CHECK_FALSE(mentions(workspace.read(folder + ending), turn));
  }
}

TEST_CASE("with --format json there are no other messages, and options for people are refused") {
  const Workspace workspace;
  const std::string generate = "elgen generate " + models + "/simple_pendulum.toml ";
  CHECK(workspace.run(generate + "--format json").errors.empty());
  for (const std::string option : {"--timings", "-v", "--dump lower"}) {
    INFO(option);
    const Outcome outcome = workspace.run(generate + "--format json " + option);
    CHECK(outcome.status == 2);
    CHECK(nlohmann::json::parse(outcome.errors).at("code") == "E913");
  }
}

TEST_CASE("a long job names its input and stage on a terminal and clears the line") {
  const std::string seen =
      run_on_terminal("elgen generate -q --size n=20 -o out " + models + "/chain.toml");
  CHECK(mentions(seen, clear_line + models + "/chain.toml: "));
  REQUIRE(seen.size() >= clear_line.size());
  CHECK(seen.substr(seen.size() - clear_line.size()) == clear_line);
}

TEST_CASE("a short job shows no progress") {
  CHECK(run_on_terminal("elgen generate -q " + models + "/simple_pendulum.toml").empty());
}

TEST_CASE("a pipe is shown no progress") {
  const Outcome outcome = run("elgen generate -q --size n=20 -o out " + models + "/chain.toml");
  CHECK(outcome.errors.empty());
  CHECK(outcome.output.empty());
}

TEST_CASE("the progress line is erased before other output") {
  const std::string seen = run("script -q -e -c \"elgen generate -q --timings --size n=20 -o out " +
                               models + "/chain.toml\" /dev/null")
                               .output;
  CHECK(mentions(seen, clear_line + "       parse"));
}

TEST_CASE("a UTF-8 terminal gets Unicode, others get plain text") {
  CHECK(mentions(show_on_terminal("LC_ALL=C.UTF-8 TERM=xterm"), "⎣ m l cos θ"));
  for (const char* const other : {"LC_ALL=C TERM=xterm", "LC_ALL=C.UTF-8 TERM=dumb"}) {
    INFO(other);
    CHECK(mentions(show_on_terminal(other), "mass_matrix[1,2] = m*l*cos(theta)"));
  }
}

}  // namespace elgen::test
