// The command line: help, version, limits, stages, and invalid words.
#include <array>
#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>
#include <sstream>
#include <vector>

#include "cli/cli_testing.hpp"
#include "elgen/limits.hpp"

namespace elgen::test {

namespace {

/// The values of --stop-after, from "--stop-after TEXT:{parse,check,…}".
std::vector<std::string> stages_of_help() {
  const std::string help = run("elgen --help").output;
  const std::size_t start = help.find('{', help.find("--stop-after")) + 1;
  std::istringstream names(help.substr(start, help.find('}', start) - start));
  std::vector<std::string> stages;
  for (std::string name; std::getline(names, name, ',');) stages.push_back(name);
  return stages;
}

}  // namespace

TEST_CASE("help starts with three examples and lists existing commands only") {
  const Outcome outcome = run("elgen --help");
  CHECK(outcome.status == 0);
  std::size_t examples = 0;
  const std::string head = outcome.output.substr(0, outcome.output.find("Usage"));
  for (std::size_t at = head.find("  elgen "); at != std::string::npos;
       at = head.find("  elgen ", at + 1)) {
    ++examples;
  }
  CHECK(examples == 3);
  for (const char* command :
       {"generate", "verify", "evaluate", "vectors", "simulate", "tradeoff", "import", "explain"}) {
    CHECK(mentions(outcome.output, command));
  }
  for (const char* format : {"json", "github"}) {
    CHECK(mentions(outcome.output, format));
  }
}

TEST_CASE("elgen without arguments prints a first command and all commands") {
  const Outcome outcome = run("elgen");
  CHECK(outcome.status == 0);
  CHECK(outcome.errors.empty());
  for (const char* command : {"generate", "show", "verify", "diff", "import", "explain"}) {
    INFO(command);
    CHECK(mentions(outcome.output, std::string("\n  ") + command + " "));
  }
}

TEST_CASE("version and limits are printed on stdout") {
  const std::string version = run("elgen --version").output;
  const std::string git = "git -C '" ELGEN_SOURCE_DIR "' ";
  if (run(git + "rev-parse HEAD").status != 0) {
    CHECK(version == "elgen 0.1.0\n");
  } else {
    REQUIRE(starts_with(version, "elgen 0.1.0 ("));
    CHECK(run(git + "cat-file -e " + version.substr(13, 12) + "^{commit}").status == 0);
    CHECK(version.substr(25) == ")\n");
  }
  const Outcome limits = run("elgen --limits");
  CHECK(limits.status == 0);
  for (const LimitRow& row : limit_table()) CHECK(mentions(limits.output, std::string(row.name)));
  const auto listed = nlohmann::json::parse(run("elgen --limits --format json").output);
  CHECK(listed.size() == limit_table().size());
  CHECK(listed.at(0).at("name") == limit_table().front().name);
}

TEST_CASE("help is a command, too, and -V prints the version") {
  CHECK(run("elgen help").output == run("elgen --help").output);
  CHECK(run("elgen help show").output == run("elgen show --help").output);
  CHECK(run("elgen -V").output == run("elgen --version").output);
}

TEST_CASE("an invalid command line exits with 2") {
  for (const char* line :
       {"elgen -q", "elgen generte x.toml", "elgen generate", "elgen generate --outptus x a.toml",
        "elgen --limit seconds=soon generate a.toml", "elgen --limit apples=3 generate a.toml"}) {
    INFO(line);
    const Outcome outcome = run(line);
    CHECK(outcome.status == 2);
    CHECK(outcome.output.empty());
    CHECK_FALSE(outcome.errors.empty());
  }
  CHECK(mentions(run("elgen generte x.toml").errors, "did you mean `generate`"));
}

TEST_CASE("a wrong command line gets the line to write") {
  const Workspace workspace;
  workspace.prepare("mkdir arms && cp " + models + "/simple_pendulum.toml base.toml && cp " +
                    models + "/cart_pole.toml arms/cart.toml");
  struct Row {
    std::string line;
    std::string message;
    std::string hint;
  };
  const std::string simulate_help = "see `elgen simulate --help`";
  for (const auto& [line, message, hint] : std::vector<Row>{
           {"generate", "inputs is required", "write NAME.toml, NAME.scene.toml or - (stdin)"},
           {"import", "input is required", "write NAME.urdf or - (stdin)"},
           {"simulate base.toml", "--time is required", "duration in s: write `--time 10`"},
           {"simulate base.toml --time 10s", "--time: `10s` is not a number: write `10`",
            simulate_help},
           {"simulate base.toml --time 1 --step 5ms",
            "--step: `5ms` is not a number: numbers have no unit", simulate_help},
           {"simulate base.toml --time 1 -o x.png",
            "`x.png` ends in none of .csv, .json, .svg and .html", "the ending selects the format"},
           {"show base.toml --as html", "--as: `--as mathml` writes a page of HTML",
            "see `elgen show --help`"},
           {"show base.toml --as pdf", "--as: `--as latex` writes a document of LaTeX",
            "see `elgen show --help`"},
           {"show base", "`base` does not exist", "did you mean `base.toml`?"},
           {"show basse.toml", "`basse.toml` does not exist", "did you mean `base.toml`?"},
           {"show arms/carts.toml", "`arms/carts.toml` does not exist",
            "did you mean `arms/cart.toml`?"}}) {
    INFO(line);
    const Outcome outcome = workspace.run("elgen " + line);
    CHECK(outcome.status == 2);
    CHECK(starts_with(outcome.errors, "elgen: error[E"));
    CHECK(mentions(outcome.errors, "]: " + message + "\n      " + hint + "\n"));
  }
}

TEST_CASE("a word that no command takes is marked, and its hint is the word to write") {
  const Workspace workspace;
  for (const auto& [line, word, hint] : std::vector<std::array<std::string, 3>>{
           {"gen base.toml", "gen", "did you mean `generate`?"},
           {"base.toml", "base.toml", "write `elgen show base.toml`"},
           {"help simlate", "simlate", "did you mean `simulate`?"},
           {"help nothing", "nothing", "see `elgen --help`"},
           {"simlate --help", "simlate", "did you mean `simulate`?"},
           {"show base.toml --latex", "--latex", "write `--as latex`"},
           {"show base.toml -o x.tex", "-o", "the result goes to stdout: write `> FILE`"},
           {"show base.toml two.toml", "two.toml", "one input at a time"},
           {"verify base.toml --json", "--json", "write `--format json`"},
           {"generate base.toml --python", "--python", "write `--language python`"},
           {"show base.toml l=2", "l=2", "see `elgen show --help`"}}) {
    const std::string written = "elgen " + line;
    INFO(written);
    const std::size_t at = written.find(" " + word) + 1;
    const Outcome outcome = workspace.run(written);
    CHECK(outcome.status == 2);
    CHECK(outcome.output.empty());
    CHECK(outcome.errors == "command line:1:" + std::to_string(at + 1) + ": error[E913]: `" + word +
                                "` is not understood\n    1 | " + written + "\n      | " +
                                std::string(at, ' ') + "^" + std::string(word.size() - 1, '~') +
                                " " + hint + "\n");
  }
}

TEST_CASE("options that ask for two results exclude each other") {
  const std::vector<std::string> options{"--check", "--list-outputs", "--stdout", "--depfile d"};
  for (std::size_t i = 0; i < options.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      INFO(options[i] << " " << options[j]);
      const Outcome outcome = run("elgen generate " + options[i] + " " + options[j] + " " + models +
                                  "/simple_pendulum.toml");
      CHECK(outcome.status == 2);
      CHECK(outcome.output.empty());
      CHECK(mentions(outcome.errors, "[E913]"));
    }
  }
}

TEST_CASE("every stage may be the last, and then nothing is written") {
  const std::vector<std::string> stages = stages_of_help();
  REQUIRE(stages.size() == 19);
  for (const std::string& stage : stages) {
    INFO(stage);
    const Workspace workspace;
    const Outcome outcome = workspace.run("elgen generate --stop-after " + stage + " " + models +
                                          "/simple_pendulum.toml");
    CHECK(outcome.status == 0);
    CHECK(outcome.output.empty());
    CHECK(workspace.run("ls").output.empty());
  }
}

TEST_CASE("equations and program are dumped") {
  for (const std::string stage : {"derive", "lower"}) {
    INFO(stage);
    const Outcome outcome = run("elgen generate --dump " + stage + " --stop-after " + stage + " " +
                                models + "/simple_pendulum.toml");
    CHECK(outcome.status == 0);
    CHECK(mentions(outcome.output, "theta"));
  }
  CHECK(run("elgen generate --dump parse " + models + "/simple_pendulum.toml").status == 2);
}

}  // namespace elgen::test
