// Sweeps over two seeds of a small model, with their certificates joined.
#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "support/installed.hpp"
#include "support/shell.hpp"

namespace elgen::test {

namespace {

const std::string sweeps = ELGEN_SOURCE_DIR "/recipes/sweeps/";
const std::string pendulum = ELGEN_SOURCE_DIR "/models/simple_pendulum.toml";

/// Checks that every joined row comes from both seeds.
void check_joined(const Workspace& workspace) {
  const Outcome joined = workspace.run("jq -s -f " + sweeps + "join.jq certificates/*.json");
  INFO(joined.errors);
  REQUIRE(joined.status == 0);
  const auto rows = nlohmann::json::parse(joined.output);
  REQUIRE_FALSE(rows.empty());
  for (const auto& row : rows) CHECK(row.at("seeds") == 2);
}

}  // namespace

TEST_CASE("GNU parallel distributes seeds, and jq joins their certificates") {
  if (!is_installed("GNU parallel", "parallel --version | grep -q GNU")) return;
  if (!is_installed("jq", "jq --version")) return;
  const Workspace workspace;
  CHECK(failure_of(workspace.run("sh " + sweeps + "sweep certificates 2 2 " + pendulum)) == "");
  CHECK(workspace.run("ls certificates").output ==
        "simple_pendulum.1.json\nsimple_pendulum.2.json\n");
  check_joined(workspace);
}

TEST_CASE("a task of a Slurm job array uses its number as seed") {
  if (!is_installed("jq", "jq --version")) return;
  const Workspace workspace;
  for (const std::string seed : {"1", "2"}) {
    workspace.prepare("SLURM_CPUS_PER_TASK=2 SLURM_ARRAY_TASK_ID=" + seed + " sh " + sweeps +
                      "slurm.sh 2 " + pendulum);
  }
  const auto second = nlohmann::json::parse(workspace.read("certificates/simple_pendulum.2.json"));
  CHECK(second.at("seed") == 2);
  check_joined(workspace);
}

}  // namespace elgen::test
