// elgen tradeoff: tables, files and exit codes; no time is looked at.
#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "cli/cli_testing.hpp"

namespace elgen::test {

namespace {

nlohmann::json table_in(const Outcome& outcome) {
  INFO(outcome.errors);
  REQUIRE(outcome.status == 0);
  return nlohmann::json::parse(outcome.output);
}

}  // namespace

TEST_CASE("a model gives ten designs, and the scene of the one chosen is as good under verify") {
  const Workspace workspace;
  const Outcome outcome = shell(
      "elgen tradeoff --as json --max-error 1e-6 --write-scene "
      "fast.scene.toml -o front.svg " +
          models + "/cart_pole.toml",
      workspace.path());
  const nlohmann::json table = table_in(outcome);
  CHECK(table["subject"] == "inverse_dynamics");
  REQUIRE(table["designs"].size() == 10);
  for (const auto& design : table["designs"]) {
    const bool is_double = design["design"]["scalar"] == "double";
    const bool is_full = design["design"]["trigonometry"] == "full";
    CHECK(design["error"]["worst"] < (is_double && is_full ? 1e-15 : 1e-6));
    CHECK(design["error"]["worst"] > (is_double && is_full ? 1e-17 : 1e-11));
  }
  CHECK(table["designs"][0]["front"] == true);
  CHECK(mentions(outcome.errors, "cheapest within 1e-06: "));
  CHECK(starts_with(read_text(workspace.path() / "front.svg"), "<svg "));
  const Outcome verified = shell("elgen verify --quick fast.scene.toml", workspace.path());
  INFO(verified.output + verified.errors);
  CHECK(verified.status == 0);
}

TEST_CASE("dimensions that are asked for are tried, expansions about the point of the scene") {
  const Workspace workspace;
  write_text(workspace.path() / "upright.scene.toml",
             "format = 1\nmodel = \"" + models +
                 "/cart_pole.toml\"\nname = \"upright\"\n[outputs]\ngravity = true\n"
                 "[approximate]\norder = 3\nabout = { x = 0, theta = 0 }\n");
  const nlohmann::json table =
      table_in(shell("elgen tradeoff -q --format json --dimensions order --range theta=-0.01..0.01 "
                     "upright.scene.toml",
                     workspace.path()));
  std::size_t expanded = 0;
  for (const auto& design : table["designs"]) {
    CHECK_FALSE(design.contains("failure"));
    if (design["design"]["order"] != "1") continue;
    ++expanded;
    CHECK(design["error"]["worst"] > 1e-5);
    CHECK(design["error"]["worst"] < 2e-5);
  }
  CHECK(expanded > 0);
}

}  // namespace elgen::test
