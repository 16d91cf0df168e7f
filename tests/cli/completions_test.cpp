#include <catch2/catch.hpp>

#include "cli/cli_testing.hpp"

using namespace elgen::test;

namespace {

/// What bash offers behind these words, in one line.
std::string offered(const std::string& words) {
  const std::string script =
      "eval \"$(elgen completions bash)\"; COMP_WORDS=(elgen " + words +
      "); COMP_CWORD=$((${#COMP_WORDS[@]} - 1)); _elgen; echo \"${COMPREPLY[*]}\"";
  return run("bash -c '" + script + "'").output;
}

bool has_shell(const std::string& shell) { return run("command -v " + shell).status == 0; }

}  // namespace

TEST_CASE("bash completes commands, options and their words") {
  CHECK(offered("ge") == "generate\n");
  CHECK(offered("show --wh") == "--what\n");
  CHECK(offered("show --as m") == "mathml markdown\n");
  CHECK(offered("show --color a") == "auto always\n");
  CHECK(offered("schema s") == "scene\n");
  CHECK(offered("-V") == "-V\n");
}

TEST_CASE("bash completes files where an input stands") {
  CHECK(run("touch cart.toml && bash -c 'eval \"$(elgen completions bash)\"; COMP_WORDS=(elgen "
            "generate ca); COMP_CWORD=2; _elgen; echo \"${COMPREPLY[*]}\"'")
            .output == "cart.toml\n");
}

TEST_CASE("zsh and fish read their scripts") {
  for (const std::string shell : {"zsh", "fish"}) {
    const Outcome script = run("elgen completions " + shell);
    INFO(shell);
    CHECK(script.status == 0);
    CHECK(script.output.find("show") != std::string::npos);
    if (!has_shell(shell)) continue;
    CHECK(run("elgen completions " + shell + " > script && " + shell + " -n script").errors == "");
  }
}
