// The certificate as programs read it.
#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "verify/sample_certificate.hpp"

using namespace elgen;
using namespace elgen::test;

TEST_CASE("as JSON nothing is left out but what is no number") {
  const auto json = nlohmann::json::parse(to_json(sample()));
  CHECK(json.at("model") == "cart_pole");
  CHECK(json.at("scene") == "full");
  CHECK(json.at("seed") == 7);
  CHECK(json.at("holds") == 3);
  CHECK(json.at("fails") == 1);
  CHECK(json.at("skipped") == 1);
  const auto& mass = json.at("checks").at(1);
  CHECK(mass.at("output") == "mass_matrix");
  CHECK(mass.at("evidence") == "states");
  CHECK(mass.at("skipped_states") == nlohmann::json{{"overflow", 2}, {"undefined", 1}});
  CHECK(mass.at("error_in_bounds") == 1.25);
  CHECK_FALSE(json.at("checks").at(2).contains("error_in_bounds"));
}
