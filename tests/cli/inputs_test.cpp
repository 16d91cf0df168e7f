// Which files a command reads: models, scenes with their model, and paths that are neither.
#include <catch2/catch.hpp>

#include "support/shell.hpp"

namespace elgen::test {

namespace {

const std::string models = std::string(ELGEN_SOURCE_DIR) + "/models";

}  // namespace

TEST_CASE("a scene finds its model relative to itself, not to the working folder") {
  const Workspace workspace;
  prepare("mkdir -p project/scenes elsewhere && cp " + models + "/cart_pole.toml project && cp " +
              models + "/scenes/balance.scene.toml project/scenes",
          workspace.path());
  CHECK(shell("cd elsewhere && elgen generate -q ../project/scenes/balance.scene.toml",
              workspace.path())
            .status == 0);
  CHECK(shell("ls elsewhere/generated", workspace.path()).output == "cart_pole_balance\n");
}

TEST_CASE("every input is read, and the worst exit code counts") {
  const Workspace workspace;
  prepare("mkdir folder.toml", workspace.path());
  const std::string good = models + "/cart_pole.toml";
  CHECK(shell("elgen generate -q " + good + " nowhere.toml", workspace.path()).status == 2);
  CHECK(shell("elgen generate -q nowhere.toml folder.toml", workspace.path()).status == 4);
  const Outcome both = shell("elgen generate -q nowhere.toml folder.toml", workspace.path());
  CHECK(mentions(both.errors, "`nowhere.toml`"));
  CHECK(mentions(both.errors, "`folder.toml`"));
}

TEST_CASE("a path with spaces and quotes is a path") {
  const Workspace workspace;
  prepare("mkdir \"it's mine\" && cp " + models + "/cart_pole.toml \"it's mine\"",
          workspace.path());
  CHECK(shell("elgen generate -q -o \"out 1\" \"it's mine/cart_pole.toml\"", workspace.path())
            .status == 0);
  CHECK(shell("ls 'out 1'", workspace.path()).output == "cart_pole\n");
}

}  // namespace elgen::test
