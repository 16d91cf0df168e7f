// elgen tradeoff --states and --over: the states and parameters at which errors are measured.
#include <algorithm>
#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "cli/cli_testing.hpp"

namespace elgen::test {
namespace {

nlohmann::json places_table(const Outcome& outcome) {
  INFO(outcome.errors);
  REQUIRE(outcome.status == 0);
  return nlohmann::json::parse(outcome.output);
}

}  // namespace

TEST_CASE("errors hold for parameters over a range, in packs and for single states") {
  const Workspace workspace;
  const nlohmann::json table = places_table(
      workspace.run("elgen tradeoff -q --as json --of gravity --over m=0.01:10,l=1:2 " + models +
                    "/simple_pendulum.toml"));
  for (const auto& design : table["designs"]) {
    CHECK_FALSE(design["design"].contains("parameters"));
    const bool is_double = design["design"]["scalar"] == "double";
    CHECK(design["error"]["worst"] < (is_double ? 2e-15 : 2e-6));
    CHECK(design["error"]["worst"] > (is_double ? 1e-17 : 1e-9));
  }
  CHECK(table["sentences"][1] ==
        "parameters vary over m=0.01:10, l=1:2: 63 draws with 16 states each");
}

TEST_CASE("errors are measured at the rows of a log, and the table says at how many") {
  const Workspace workspace;
  const std::string model = models + "/simple_pendulum.toml";
  workspace.prepare("elgen simulate -q --time 1 --every 5e-4 -o run.csv " + model);
  const std::string log = workspace.read("run.csv");
  const auto rows = std::ranges::count(log, '\n') - 1;
  REQUIRE(rows > 1900);
  const nlohmann::json table = places_table(
      workspace.run("elgen tradeoff -q --as json --of gravity --batch one --states run.csv "
                    "--max-error 1 --write-scene x.scene.toml " +
                    model));
  CHECK(table["sentences"][1] ==
        "the states are 1008 of " + std::to_string(rows) + " rows of run.csv, spread evenly");
  for (const auto& design : table["designs"]) CHECK(design["error"]["worst"] < 1e-6);
  CHECK_FALSE(mentions(workspace.read("x.scene.toml"), "max_error"));
  CHECK(workspace.run("elgen tradeoff --states none.csv " + model).status == 2);
  CHECK(workspace.run("elgen tradeoff --trajectory 1 --states run.csv " + model).status == 2);
}

}  // namespace elgen::test
