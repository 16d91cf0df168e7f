// elgen generate: what its options make of the files it would write.
#include <catch2/catch.hpp>

#include "cli/cli_testing.hpp"

namespace elgen::test {

TEST_CASE("a scene's base name is the model's and its own") {
  const Workspace workspace;
  const Outcome outcome =
      shell("elgen generate -q -o out " + models + "/scenes/balance.scene.toml", workspace.path());
  INFO(outcome.errors);
  CHECK(outcome.status == 0);
  CHECK(files_below(workspace.path()) ==
        "./out/cart_pole_balance/cart_pole_balance.equations.json\n"
        "./out/cart_pole_balance/cart_pole_balance.hpp\n"
        "./out/cart_pole_balance/cart_pole_balance.md\n");
}

TEST_CASE("`files` of a scene leaves out the sidecar and the page") {
  const Project project;
  write_text(
      project.path() / "bare.scene.toml",
      "format = 1\nmodel = \"cart_pole.toml\"\nname = \"bare\"\n[outputs]\nmass_matrix = true\n"
      "[emit]\nfiles = [\"header\"]\n");
  CHECK(project.run("elgen generate -q bare.scene.toml").status == 0);
  CHECK(project.run("ls generated/cart_pole_bare").output == "cart_pole_bare.hpp\n");
  CHECK(project.run("elgen generate --check -q bare.scene.toml").status == 0);
  project.change("sed -i 's/mass_matrix/bias/' bare.scene.toml");
  CHECK(project.run("elgen generate --check -q bare.scene.toml").status == 1);
}

TEST_CASE("option --stdout prints the header and writes nothing") {
  const Workspace workspace;
  const Outcome outcome =
      shell("elgen generate --stdout " + models + "/cart_pole.toml", workspace.path());
  CHECK(outcome.status == 0);
  CHECK(starts_with(outcome.output, marker));
  CHECK(files_below(workspace.path()).empty());
}

TEST_CASE("option --list-outputs prints the paths and writes nothing") {
  const Workspace workspace;
  const Outcome outcome =
      shell("elgen generate --list-outputs -o out " + models + "/cart_pole.toml", workspace.path());
  CHECK(outcome.status == 0);
  CHECK(outcome.output ==
        "out/cart_pole/cart_pole.equations.json\nout/cart_pole/cart_pole.hpp\n"
        "out/cart_pole/cart_pole.md\n");
  CHECK(files_below(workspace.path()).empty());
}

TEST_CASE("option --depfile names what the output depends on, in the language of make") {
  const Workspace workspace;
  prepare("cp -r " + models + " models", workspace.path());
  const Outcome outcome =
      shell("elgen generate -q -o out --depfile out.d models/scenes/balance.scene.toml",
            workspace.path());
  REQUIRE(outcome.status == 0);
  const std::string stem = "out/cart_pole_balance/cart_pole_balance";
  const std::string sources = ": models/cart_pole.toml models/scenes/balance.scene.toml\n";
  CHECK(read_text(workspace.path() / "out.d") ==
        stem + ".equations.json" + sources + stem + ".hpp" + sources + stem + ".md" + sources);
}

TEST_CASE("options that would change the model's own output are refused without -o") {
  const Workspace workspace;
  const std::string generate = "elgen generate -q " + models + "/chain.toml ";
  for (const std::string option : {"--outputs mass_matrix", "--fix g", "--size n=2"}) {
    INFO(option);
    CHECK(shell("rm -rf generated && " + generate + option, workspace.path()).status == 0);
    REQUIRE(shell("rm -rf generated && " + generate, workspace.path()).status == 0);
    const Outcome outcome = shell(generate + option, workspace.path());
    CHECK(outcome.status == 2);
    CHECK(mentions(outcome.errors, "[E607]"));
    CHECK(shell(generate + option + " -o other", workspace.path()).status == 0);
  }
}

TEST_CASE("a line says what was checked, and that [[expect]] was not") {
  const Workspace workspace;
  const Outcome outcome =
      shell("elgen generate -o out " + models + "/simple_pendulum.toml", workspace.path());
  CHECK(outcome.status == 0);
  CHECK(mentions(outcome.errors, "simple_pendulum: the program was checked at "));
  CHECK(mentions(outcome.errors, " uB; [[expect]] is left to `elgen verify`\n"));
}

}  // namespace elgen::test
