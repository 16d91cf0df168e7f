// A report as programs read it.
#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "diff/versions.hpp"

using namespace elgen;
using namespace elgen::test;

TEST_CASE("changes have ids that stay, and places") {
  const auto json = nlohmann::json::parse(
      to_json({.systems = {compared(cart, edited(cart, "\"-g\"", "\"g\""))}}));
  CHECK(json.at("format") == "elgen diff 1");
  CHECK(json.at("impact") == "different");
  const auto& system = json.at("systems").at(0);
  const auto& key = system.at("keys").at(0);
  CHECK(key.at("id") == "[gravity]/vector[2]");
  CHECK(key.at("new_place").at("line") == 55);
  const auto& output = system.at("outputs").at(0);
  CHECK(output.at("name") == "gravity");
  const auto& change = output.at("changes").at(0);
  CHECK(change.at("id") == "gravity[2]");
  CHECK(change.at("verdict") == "different");
  CHECK(change.at("difference") == "2*m*l*g*sin(theta)");
  CHECK(change.at("witness").at("at") == "theta = 1.68");
}

TEST_CASE("what is equal says whether that is proved, what is missing is null") {
  const auto json = nlohmann::json::parse(
      to_json({.systems = {compared(spring("k*(1 - cos(x))"), spring("2*k*sin(x/2)^2"))},
               .added = {"a.toml"}}));
  const auto& change = json.at("systems").at(0).at("outputs").at(0).at("changes").at(0);
  CHECK(change.at("verdict") == "equal");
  CHECK(change.at("proved") == true);
  CHECK(json.at("added").at(0) == "a.toml");
}
