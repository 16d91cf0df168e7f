// The schema of a report has its keys; tests/cli/schema_test.cpp judges what the program prints.
#include "diff/diff_schema.hpp"

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "elgen/diff.hpp"

using namespace elgen;

TEST_CASE("the schema has the keys of a report, and all words of impacts") {
  const auto schema = nlohmann::json::parse(diff_schema());
  const auto& keys = schema.at("properties");
  const auto report = nlohmann::json::parse(to_json(DiffReport{}));
  for (const auto& [name, value] : report.items()) {
    INFO(name);
    CHECK(keys.contains(name));
  }
  for (const nlohmann::json& word : keys.at("impact").at("enum")) {
    CHECK(find_impact(word.get<std::string>()).has_value());
  }
}
