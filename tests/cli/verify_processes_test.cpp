// elgen verify: several processes share the samples.
#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "cli/cli_testing.hpp"

namespace elgen::test {

TEST_CASE("the certificate depends on the seed, but not on the number of processes") {
  const Workspace workspace;
  write_rotor(workspace);
  const auto verified = [&](const std::string& options) {
    return workspace.run("elgen verify --build users -v one.scene.toml --samples 40 " + options);
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
  const Outcome outcome = workspace.run(
      "elgen verify --quick --format json --samples 2500 --limit seconds=600 one.scene.toml");
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

TEST_CASE("the limit of processor time applies to each process, and ends all of them") {
  const Workspace workspace;
  write_rotor(workspace);
  const std::string command = "elgen verify --quick --samples 200000 --jobs 2 --limit seconds=1 ";
  const Outcome outcome = workspace.run(command + "one.scene.toml");
  CHECK(outcome.status == 3);
  CHECK(mentions(outcome.errors,
                 "[E909]: 1 s of processor time are used up, in `accuracy in double`"));
}

TEST_CASE("an interrupt ends the processes that share states and leaves no files") {
  const Workspace workspace;
  write_rotor(workspace);
  const Outcome outcome = workspace.run(
      "mkdir t; export TMPDIR=$PWD/t\n"
      "elgen verify --build written one.scene.toml --limit seconds=600 --samples 200000 --jobs 2 & "
      "id=$!\n"
      "until test \"$(wc -w < /proc/$id/task/$id/children)\" = 2; do sleep 0.1; done\n"
      "children=$(cat /proc/$id/task/$id/children)\n"
      "kill -TERM $id; wait $id; echo $?\n"
      "for child in $children; do kill -0 $child 2>/dev/null && echo runs; done\n"
      "ls t");
  INFO(outcome.errors);
  CHECK(outcome.output == "130\n");
}

}  // namespace elgen::test
