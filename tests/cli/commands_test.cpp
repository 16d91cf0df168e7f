// Commands: the help lists every command of the table, in order. Every command has its own help, a
// section in the manual, and completions in shells.
#include <catch2/catch.hpp>

#include "cli/cli_testing.hpp"

namespace elgen::test {
namespace {

/// The completions of bash after `words`, in one line.
std::string bash_completions(const std::string& words) {
  const std::string script =
      "eval \"$(elgen completions bash)\"; COMP_WORDS=(elgen " + words +
      "); COMP_CWORD=$((${#COMP_WORDS[@]} - 1)); _elgen; echo \"${COMPREPLY[*]}\"";
  return run("bash -c '" + script + "'").output;
}

bool has_shell(const std::string& shell) { return run("command -v " + shell).status == 0; }

}  // namespace

TEST_CASE("help lists the commands in the order of the table") {
  const Workspace workspace;
  const std::string help = workspace.run("elgen --help").output;
  std::size_t at = help.find("Subcommands");
  for (const std::string name : {
#define ELGEN_COMMAND(name) #name,
#include "cli/commands.def"
#undef ELGEN_COMMAND
       }) {
    INFO(name);
    const std::size_t next = help.find("\n  " + name + " ", at);
    REQUIRE(next != std::string::npos);
    at = next;
    CHECK(workspace.run("elgen " + name + " --help").status == 0);
  }
}

TEST_CASE("options of several commands are accepted by each") {
  const Workspace workspace;
  const std::string model = ELGEN_SOURCE_DIR "/models/simple_pendulum.toml";
  for (const char* command : {"generate --stdout ", "show "}) {
    const Outcome outcome =
        workspace.run("elgen " + std::string(command) + "--fix m=2 --fix l=3 " + model);
    INFO(outcome.output);
    CHECK(outcome.status == 0);
    CHECK_FALSE(mentions(outcome.output, "m*l"));
  }
}

TEST_CASE("the manual has a section for every command in --help") {
  const std::string manual = run("elgen man").output;
  const std::string help = run("elgen --help").output;
  const std::size_t commands = help.find("Subcommands:");
  REQUIRE(commands != std::string::npos);
  std::istringstream lines(help.substr(help.find('\n', commands) + 1));
  int count = 0;
  for (std::string line; std::getline(lines, line) && line.starts_with("  ");) {
    if (line[2] == ' ') continue;  // continuation of a description
    const std::string name = line.substr(2, line.find(' ', 2) - 2);
    INFO(name);
    CHECK(mentions(manual, "\n.SS " + name + "\n"));
    ++count;
  }
  CHECK(count >= 9);
}

TEST_CASE("bash completes commands, options and their words") {
  CHECK(bash_completions("ge") == "generate\n");
  CHECK(bash_completions("show --wh") == "--what\n");
  CHECK(bash_completions("show --as m") == "mathml markdown\n");
  CHECK(bash_completions("show --color a") == "auto always\n");
  CHECK(bash_completions("schema s") == "scene\n");
  CHECK(bash_completions("-V") == "-V\n");
}

TEST_CASE("bash completes file names for inputs") {
  CHECK(run("touch cart.toml && bash -c 'eval \"$(elgen completions bash)\"; COMP_WORDS=(elgen "
            "generate ca); COMP_CWORD=2; _elgen; echo \"${COMPREPLY[*]}\"'")
            .output == "cart.toml\n");
}

TEST_CASE("zsh and fish accept their scripts") {
  for (const std::string shell : {"zsh", "fish"}) {
    const Outcome script = run("elgen completions " + shell);
    INFO(shell);
    CHECK(script.status == 0);
    CHECK(mentions(script.output, "show"));
    if (!has_shell(shell)) continue;
    CHECK(run("elgen completions " + shell + " > script && " + shell + " -n script").errors == "");
  }
}

TEST_CASE("the manual lists options with their arguments, and exit codes") {
  const Outcome manual = run("elgen man");
  CHECK(manual.status == 0);
  CHECK(manual.output.starts_with(".TH ELGEN 1 "));
  CHECK(mentions(manual.output, "\n.TP\n\\fB\\-\\-color\\fR \\fIauto|\\:always|\\:never\\fR\n"));
  CHECK(mentions(manual.output, "\n.TP\n130\ninterrupted"));
}

TEST_CASE("no line of text in the manual is a troff request") {
  for (const std::string& line : split_lines(run("elgen man").output)) {
    if (!line.starts_with('.') && !line.starts_with('\'')) continue;
    const std::string request = line.substr(0, 3);
    INFO(line);
    const bool is_known = request == ".TH" || request == ".SH" || request == ".SS" ||
                          request == ".TP" || request == ".B " || request == ".I " ||
                          request == ".RI" || request == ".nf" || request == ".fi";
    CHECK(is_known);
  }
}

TEST_CASE("a shell without completions is refused") {
  const Outcome refused = run("elgen completions tcsh");
  CHECK(refused.status == 2);
  CHECK(mentions(refused.errors, "see `elgen completions --help`"));
}

}  // namespace elgen::test
