// elgen verify with many samples: all are visited, by several processes, with one certificate.
#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "support/shell.hpp"

namespace elgen::test {

namespace {

/// One output, so that a thousand visits take a moment.
void write_rotor(const Workspace& workspace) {
  write_text(workspace.path() / "rotor.toml",
             "format = 1\n[model]\nname = \"rotor\"\n[[coordinate]]\nname = \"q\"\nunit = \"rad\"\n"
             "[parameters]\nJ = { value = 2, unit = \"kg*m^2\" }\nk = { value = 3, unit = \"J\" }\n"
             "[energy]\nT = \"1/2*J*dot(q)^2\"\nV = \"k*(1 - cos(q))\"\n");
  write_text(workspace.path() / "one.scene.toml",
             "format = 1\nmodel = \"rotor.toml\"\nname = \"one\"\n[outputs]\nbias = true\n");
}

}  // namespace

TEST_CASE("the certificate is the same whatever the number of processes, not so of the seed") {
  const Workspace workspace;
  write_rotor(workspace);
  const auto verified = [&](const std::string& options) {
    return shell("elgen verify -v one.scene.toml --samples 40 " + options, workspace.path());
  };
  const Outcome alone = verified("--jobs 1");
  INFO(alone.output + alone.errors);
  CHECK(alone.status == 0);
  CHECK(mentions(alone.output, "as users compile"));
  CHECK(verified("--jobs 3").output == alone.output);
  CHECK(verified("").output == alone.output);
  CHECK(verified("--seed 2").output != alone.output);
}

TEST_CASE("all samples are visited, however many") {
  const Workspace workspace;
  write_rotor(workspace);
  const Outcome outcome =
      shell("elgen verify --quick --format json --samples 2500 --limit seconds=600 one.scene.toml",
            workspace.path());
  INFO(outcome.errors);
  REQUIRE(outcome.status == 0);
  std::size_t compared = 0;
  const auto certificate = nlohmann::json::parse(outcome.output);
  for (const auto& row : certificate.at("checks")) {
    if (row.at("check") != "program vs oracle") continue;
    ++compared;
    std::size_t visited = row.at("samples");
    for (const auto& skipped : row.at("skipped_states")) visited += skipped.get<std::size_t>();
    CHECK(visited >= 2500);
  }
  CHECK(compared == 2);
}

TEST_CASE("processor time is that of each process, and ends all of them") {
  const Workspace workspace;
  write_rotor(workspace);
  const Outcome outcome = shell(
      "elgen verify --quick --samples 200000 --jobs 2 --limit seconds=1 one.scene.toml",
      workspace.path());
  CHECK(outcome.status == 3);
  CHECK(outcome.errors ==
        "elgen: error[E909]: 1 s of processor time are over\n      raised by --limit seconds=N\n");
}

TEST_CASE("an interrupt ends the processes that share states, and leaves no files") {
  const Workspace workspace;
  write_rotor(workspace);
  const Outcome outcome = shell(
      "mkdir t; export TMPDIR=$PWD/t\n"
      "elgen verify one.scene.toml --limit seconds=600 --samples 200000 --jobs 2 & id=$!\n"
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
