// generate --check: files of ours that nothing generates any more.
#include <catch2/catch.hpp>

#include "cli/cli_testing.hpp"

namespace elgen::test {

namespace {

/// A model, a scene and what they generate.
class ModelAndScene : public Workspace {
 public:
  ModelAndScene() {
    prepare("mkdir -p scenes && cp " + models + "/cart_pole.toml . && cp " + models +
                "/scenes/balance.scene.toml scenes && " + generate,
            path());
  }
  [[nodiscard]] Outcome check(const std::string& change) const {
    prepare(change, path());
    return shell("elgen generate --check *.toml scenes/*.toml", path());
  }
  const std::string generate = "elgen generate -q cart_pole.toml scenes/balance.scene.toml";
};

}  // namespace

TEST_CASE("the folder of a scene that was renamed is found") {
  const ModelAndScene project;
  const Outcome outcome = project.check(
      "sed -i 's/^name *= *\"balance\"/name = \"upright\"/' scenes/balance.scene.toml && "
      "elgen generate -q *.toml scenes/*.toml");
  CHECK(outcome.status == 1);
  CHECK(mentions(outcome.output,
                 "orphaned     generated/cart_pole_balance/cart_pole_balance.hpp: "
                 "scenes/balance.scene.toml has another name now\n"));
  CHECK(mentions(outcome.errors,
                 "to repair: delete generated/cart_pole_balance/cart_pole_balance.hpp\n"));
  CHECK_FALSE(mentions(outcome.errors, "elgen generate"));
}

TEST_CASE("the folder of a file that moved or went is found") {
  const ModelAndScene project;
  const Outcome outcome = project.check(
      "mv scenes/balance.scene.toml scenes/upright.scene.toml && mkdir generated/mine "
      "&& touch generated/mine/notes.txt");
  CHECK(outcome.status == 1);
  CHECK(mentions(outcome.output, "stale        generated/cart_pole_balance/cart_pole_balance.hpp"));
  CHECK_FALSE(mentions(outcome.output, "mine"));
  const Outcome gone = project.check(
      "rm scenes/*; cp cart_pole.toml scenes/cart.toml && sed -i "
      "'s/\"cart_pole\"/\"cart\"/' scenes/cart.toml && elgen "
      "generate -q scenes/cart.toml");
  CHECK(mentions(gone.output, "cart_pole_balance.md: there is no scenes/balance.scene.toml\n"));
}

TEST_CASE("folders of files that are there and were not asked for are left alone") {
  const ModelAndScene project;
  CHECK(shell("elgen generate --check cart_pole.toml", project.path()).status == 0);
}

TEST_CASE("a file beside the generated ones is an orphan if it bears our mark") {
  const ModelAndScene project;
  const Outcome outcome = project.check(
      "cp generated/cart_pole/cart_pole.hpp generated/cart_pole/old.hpp && touch "
      "generated/cart_pole/notes.hpp");
  CHECK(outcome.output == "orphaned     generated/cart_pole/old.hpp: nothing generates it\n");
  CHECK(outcome.errors ==
        "elgen: error[E715]: 1 generated file is not current\n"
        "to repair: delete generated/cart_pole/old.hpp\n");
}

}  // namespace elgen::test
