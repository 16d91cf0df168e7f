// A table for programs.
#include <catch2/catch.hpp>
#include <cmath>
#include <nlohmann/json.hpp>

#include "tradeoff/tables.hpp"

using namespace elgen;
using namespace elgen::test;

TEST_CASE("the object has a design for every row") {
  TradeoffTable table = judged(sample_table());
  table.sentences = {"one"};
  const auto json = nlohmann::json::parse(to_json(table));
  CHECK(json["model"] == "arm");
  REQUIRE(json["designs"].size() == 5);
  const auto& first = json["designs"][0];
  CHECK(first["design"]["scalar"] == "float");
  CHECK(first["cost"]["median"] == 4);
  CHECK(first["error"]["worst"] == 2e-7);
  CHECK(first["front"] == true);
  CHECK(json["designs"][4]["failure"] == "E709: \"c++\" exits 1");
  CHECK_FALSE(json["designs"][4].contains("cost"));
  CHECK(json["sentences"].size() == 1);
}

TEST_CASE("what is infinitely wrong is null in JSON") {
  const TradeoffTable table{.dimensions = {"a"}, .rows = {row_of({"1"}, 1, INFINITY)}};
  CHECK(nlohmann::json::parse(to_json(table))["designs"][0]["error"]["worst"].is_null());
}

TEST_CASE("cells with quotes are quoted, failed rows have none of the numbers") {
  TradeoffTable table = judged(sample_table());
  table.rows.erase(table.rows.begin() + 1, table.rows.end() - 1);
  CHECK(to_csv(table) ==
        "scalar,batch,cost,cost_low,cost_high,worst_error,median_error,front,failure\n"
        "float,packs,4,3.8,4.2,2e-07,5e-08,1,\n"
        "half,1,,,,,,0,\"E709: \"\"c++\"\" exits 1\"\n");
}
