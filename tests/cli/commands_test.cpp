// Every command of the table is offered, in its order, and explains itself.
#include <catch2/catch.hpp>

#include "support/shell.hpp"

namespace elgen::test {

TEST_CASE("help has the commands in the order of their table") {
  const Workspace workspace;
  const std::string help = shell("elgen --help", workspace.path()).output;
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
    CHECK(shell("elgen " + name + " --help", workspace.path()).status == 0);
  }
}

TEST_CASE("options of several commands are read in each") {
  const Workspace workspace;
  const std::string model = ELGEN_SOURCE_DIR "/models/simple_pendulum.toml";
  for (const char* command : {"generate --stdout ", "show "}) {
    const Outcome outcome =
        shell("elgen " + std::string(command) + "--fix m=2 --fix l=3 " + model, workspace.path());
    INFO(outcome.output);
    CHECK(outcome.status == 0);
    CHECK_FALSE(mentions(outcome.output, "m*l"));
  }
}

}  // namespace elgen::test
