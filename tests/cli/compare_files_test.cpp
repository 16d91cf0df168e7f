// generate --check: committed output that is current, stale, edited by hand, or left over.
#include <catch2/catch.hpp>

#include "cli/cli_testing.hpp"

namespace elgen::test {

TEST_CASE("the committed output of every model and scene is current") {
  const Outcome outcome =
      shell("elgen generate --check models/*.toml models/scenes/*.scene.toml", ELGEN_SOURCE_DIR);
  INFO(outcome.output + outcome.errors);
  CHECK(outcome.status == 0);
}

TEST_CASE("output just written is current, and checking writes nothing") {
  const Project project;
  const std::string listing = project.run("ls -lR --full-time generated").output;
  CHECK(project.check().status == 0);
  CHECK(project.run("ls -lR --full-time generated").output == listing);
}

TEST_CASE("a changed model makes its output stale: its files and the remedy are shown") {
  const Project project;
  project.change("sed -i 's/\\[\"0\", \"-g\"\\]/[\"0\", \"-2*g\"]/' cart_pole.toml");
  const Outcome outcome = project.check();
  CHECK(outcome.status == 1);
  const std::string text = outcome.output + outcome.errors;
  CHECK(mentions(text, "stale        generated/cart_pole/cart_pole.hpp"));
  CHECK(mentions(text, "elgen generate cart_pole.toml"));
}

TEST_CASE("an edit by hand is told from a stale file") {
  const Project project;
  project.change("sed -i 's/mass_matrix/mass_Matrix/' generated/cart_pole/cart_pole.hpp");
  const Outcome outcome = project.check();
  CHECK(outcome.status == 1);
  CHECK(mentions(outcome.output + outcome.errors, "by hand"));
}

TEST_CASE("a missing file is found") {
  const Project missing;
  missing.change("rm generated/cart_pole/cart_pole.equations.json");
  const Outcome gone = missing.check();
  CHECK(gone.status == 1);
  CHECK(mentions(gone.output + gone.errors, "generated/cart_pole/cart_pole.equations.json"));
}

TEST_CASE("generating again repairs what --check complains about") {
  const Project project;
  project.change("sed -i 's/mass_matrix/mass_Matrix/' generated/cart_pole/cart_pole.hpp");
  REQUIRE(project.check().status == 1);
  CHECK(project.run("elgen generate -q cart_pole.toml").status == 0);
  CHECK(project.check().status == 0);
}

TEST_CASE("the command that --check prints repairs, whatever the options") {
  for (const std::string options :
       {"", " --outputs mass_matrix,bias", " --fix g -o 'my out'", " --fix m=1/2 --fix g"}) {
    INFO(options);
    const Workspace workspace;
    prepare("mkdir 'a b' && cp " + models + "/cart_pole.toml 'a b'", workspace.path());
    const std::string check = "elgen generate --check 'a b/cart_pole.toml'" + options;
    const std::string errors = shell(check, workspace.path()).errors;
    const std::string lead = "to repair: ";
    REQUIRE(mentions(errors, lead));
    const std::size_t start = errors.find(lead) + lead.size();
    const std::string repair = errors.substr(start, errors.find('\n', start) - start);
    INFO(repair);
    CHECK(shell(repair, workspace.path()).status == 0);
    CHECK(shell(check, workspace.path()).status == 0);
  }
}

}  // namespace elgen::test
