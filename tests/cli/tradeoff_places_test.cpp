// elgen tradeoff --over: the parameters at which errors are measured.
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
    if (design["design"].value("trigonometry", "full") == "1e-7") continue;
    const bool is_double = design["design"]["scalar"] == "double";
    CHECK(design["error"]["worst"] < (is_double ? 2e-15 : 2e-6));
    CHECK(design["error"]["worst"] > (is_double ? 1e-17 : 1e-9));
  }
  CHECK(table["sentences"][1] ==
        "parameters vary over m=0.01:10, l=1:2: 63 draws with 16 states each");
}

}  // namespace elgen::test
