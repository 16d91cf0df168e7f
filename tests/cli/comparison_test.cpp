// elgen verify with many samples: screened, the worst of them visited, the same for any --jobs.
#include <catch2/catch.hpp>

#include "support/shell.hpp"

namespace elgen::test {

namespace {

/// One output, so that a thousand visits take a moment.
void write_rotor(const Workspace& workspace, const std::string& emission = "") {
  write_text(workspace.path() / "rotor.toml",
             "format = 1\n[model]\nname = \"rotor\"\n[[coordinate]]\nname = \"q\"\nunit = \"rad\"\n"
             "[parameters]\nJ = { value = 2, unit = \"kg*m^2\" }\nk = { value = 3, unit = \"J\" }\n"
             "[energy]\nT = \"1/2*J*dot(q)^2\"\nV = \"k*(1 - cos(q))\"\n");
  write_text(
      workspace.path() / "one.scene.toml",
      "format = 1\nmodel = \"rotor.toml\"\nname = \"one\"\n[outputs]\nbias = true\n" + emission);
}

}  // namespace

TEST_CASE("more than 2000 samples are screened, whatever the number of processes") {
  const Workspace workspace;
  write_rotor(workspace);
  const auto verified = [&](const std::string& options) {
    return shell("elgen verify one.scene.toml --limit seconds=600 --samples " + options,
                 workspace.path());
  };
  const Outcome screened = verified("2001");
  INFO(screened.output + screened.errors);
  CHECK(screened.status == 0);
  CHECK(mentions(screened.output, "screened 20"));
  CHECK(mentions(screened.output, " states in double, of which 1000 visited\n"));
  CHECK(mentions(screened.output, " states in float, of which 1000 visited\n"));
  CHECK(mentions(screened.output, "as users compile"));
  CHECK(verified("2001 --jobs 3").output == screened.output);
  const std::string few = verified("20 --quick -v").output;
  CHECK_FALSE(mentions(few, "screened"));
  CHECK(verified("20 --quick -v --seed 2").output != few);
}

TEST_CASE("code in C is screened by its functions in C++") {
  const Workspace workspace;
  write_rotor(workspace, "[numeric]\nscalar = [\"double\"]\n[emit]\nlanguage = \"c99\"\n");
  const Outcome screened =
      shell("elgen verify one.scene.toml --limit seconds=600 --samples 2001", workspace.path());
  INFO(screened.output + screened.errors);
  CHECK(screened.status == 0);
  CHECK(mentions(screened.output, " states in double, of which 1000 visited\n"));
}

TEST_CASE("an interrupt ends screening, and leaves neither processes nor files") {
  const Workspace workspace;
  write_rotor(workspace);
  const Outcome outcome = shell(
      "mkdir t; export TMPDIR=$PWD/t\n"
      "elgen verify one.scene.toml --limit seconds=600 --samples 100000000 --jobs 2 & id=$!\n"
      "until test \"$(wc -w < /proc/$id/task/$id/children)\" = 2; do sleep 0.1; done\n"
      "children=$(cat /proc/$id/task/$id/children)\n"
      "kill -TERM $id; wait $id; echo $?\n"
      "for child in $children; do kill -0 $child 2>/dev/null && echo runs; done\n"
      "ls t",
      workspace.path());
  INFO(outcome.errors);
  CHECK(outcome.output == "130\n");
}

}  // namespace elgen::test
