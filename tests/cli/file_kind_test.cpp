// What stands in a place that is no regular file, and stays there.
#include <catch2/catch.hpp>

#include "cli/cli_testing.hpp"

namespace elgen::test {

TEST_CASE("what is no regular file is never replaced") {
  const Workspace workspace;
  prepare(
      "mkdir folder && mkfifo fifo && echo mine > file && ln -s file link && ln -s nowhere loose",
      workspace.path());
  const std::string model = models + "/cart_pole.toml";
  for (const auto& [place, kind] :
       {std::pair{"folder", "a folder"}, std::pair{"fifo", "a FIFO"},
        std::pair{"link", "a symbolic link"}, std::pair{"loose", "a symbolic link"},
        std::pair{"/dev/null", "a device"}}) {
    INFO(place);
    const Outcome outcome =
        shell("elgen generate -q --force " + model + " --depfile " + place, workspace.path());
    CHECK(outcome.status == 4);
    CHECK(mentions(outcome.errors, std::string("`") + place + "` is " + kind + ", not a file\n"));
  }
  CHECK(shell("test -c /dev/null && test -p fifo && test -L link && cat file", workspace.path())
            .output == "mine\n");
  CHECK_FALSE(shell("test -e generated", workspace.path()).status == 0);
}

}  // namespace elgen::test
