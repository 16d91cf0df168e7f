// Tables: the order of rows, the front, what is chosen, and how people and programs see them. Costs
// and errors are made up, so that nothing is measured.
#include <tinyxml2.h>

#include <catch2/catch.hpp>
#include <cmath>
#include <nlohmann/json.hpp>

#include "elgen/tradeoff.hpp"
#include "support/shell.hpp"

using namespace elgen;
using namespace elgen::test;

namespace {

/// Quartiles 5 % to either side of the cost.
TradeoffRow row_of(std::vector<std::string> values, double cost, double error) {
  return {.values = std::move(values),
          .cost = {cost, 0.95 * cost, 1.05 * cost},
          .error = {error, error / 4}};
}

TradeoffRow failed_row(std::vector<std::string> values, std::string why) {
  return {.values = std::move(values), .failure = std::move(why)};
}

/// Of two scalars, in packs or not, measured in the order of a plan.
TradeoffTable sample_table() {
  return {.model = "arm",
          .subject = "gravity",
          .cost = "ns per state",
          .error = "errors, relative",
          .dimensions = {"scalar", "batch"},
          .rows = {row_of({"double", "1"}, 40, 1e-16), row_of({"double", "packs"}, 8, 2e-16),
                   row_of({"float", "1"}, 40.5, 1e-7), row_of({"float", "packs"}, 4, 2e-7),
                   failed_row({"half", "1"}, "E709: \"c++\" exits 1")},
          .machine = {.compiler = "g++ 12", .processor = "a processor"}};
}

}  // namespace

TEST_CASE("the cheapest row is first, failed ones are last, and what nothing beats is the front") {
  const TradeoffTable table = judged(sample_table());
  REQUIRE(table.rows.size() == 5);
  CHECK(name_of(table.rows[0]) == "float, packs");
  CHECK(name_of(table.rows[1]) == "double, packs");
  CHECK(name_of(table.rows[2]) == "double, 1");
  CHECK(name_of(table.rows[3]) == "float, 1");
  CHECK(name_of(table.rows[4]) == "half, 1");
  std::vector<bool> front;
  for (const TradeoffRow& row : table.rows) front.push_back(row.is_on_front);
  CHECK(front == std::vector<bool>{true, true, true, false, false});
}

TEST_CASE("what is below the reference is not ranked, and is chosen by what that is known to") {
  TradeoffTable table = sample_table();
  table.rows[0] = row_of({"double", "1"}, 2, 1e-13);
  table.rows[0].is_below_reference = true;
  table = judged(table);
  CHECK(name_of(table.rows[0]) == "double, 1");
  CHECK_FALSE(table.rows[0].is_on_front);
  CHECK(mentions(to_text(table), "below the reference\n"));
  CHECK(name_of(*cheapest_within(table, 1e-12)) == "double, 1");
  const auto json = nlohmann::json::parse(to_json(table))["designs"];
  CHECK(json[0]["error"]["below_reference"] == true);
  CHECK_FALSE(json[1]["error"].contains("below_reference"));
}

TEST_CASE("the cheapest design within an error, and the most accurate one") {
  const TradeoffTable table = judged(sample_table());
  CHECK(name_of(*cheapest_within(table, 1e-6)) == "float, packs");
  CHECK(name_of(*cheapest_within(table, 1e-15)) == "double, packs");
  CHECK(cheapest_within(table, 1e-17) == nullptr);
  CHECK(name_of(*most_accurate(table)) == "double, 1");
  CHECK(most_accurate(TradeoffTable{.rows = {failed_row({}, "E705")}}) == nullptr);
}

TEST_CASE("of designs that are as good as each other all are on the front") {
  const TradeoffTable table =
      judged({.dimensions = {"a"}, .rows = {row_of({"1"}, 5, 1), row_of({"2"}, 5, 1)}});
  CHECK(table.rows[0].is_on_front);
  CHECK(table.rows[1].is_on_front);
}

TEST_CASE("rows are in columns, those of the front have a star, a failed one says why") {
  TradeoffTable table = judged(sample_table());
  table.sentences = {"one", "two"};
  CHECK(to_text(table) == R"(arm, gravity: ns per state; errors, relative

  scalar  batch  ns    quartiles       worst error  median error
* float   packs  4     3.8 to 4.2      2.0e-07      5.0e-08
* double  packs  8     7.6 to 8.4      2.0e-16      5.0e-17
* double  1      40    38 to 42        1.0e-16      2.5e-17
  float   1      40.5  38.48 to 42.52  1.0e-07      2.5e-08
  half    1      E709: "c++" exits 1

one
two
measured on a processor, g++ 12
)");
}

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

TEST_CASE("a picture is XML with every design that has numbers, and the front joined") {
  const std::string svg = to_svg(judged(sample_table()));
  tinyxml2::XMLDocument document;
  REQUIRE(document.Parse(svg.c_str()) == tinyxml2::XML_SUCCESS);
  CHECK(count(svg, "fill=\"black\"") == 2 * 3);
  CHECK(count(svg, "transform=") == 2 * 4);
  CHECK(mentions(svg, ">1  float, packs<"));
  CHECK(mentions(svg, "arm, gravity"));
  CHECK_FALSE(mentions(svg, "E709"));
}

TEST_CASE("shapes tell the values of the first dimension apart") {
  const std::string svg = to_svg(judged(sample_table()));
  CHECK(count(svg, "d=\"M-5 0A") == 4);
  CHECK(count(svg, "d=\"M-4.5 ") == 4);
}

TEST_CASE("errors without a logarithm stay inside the picture") {
  const std::string svg = to_svg(
      judged({.dimensions = {"a"}, .rows = {row_of({"1"}, 1, 0), row_of({"2"}, 0.5, INFINITY)}}));
  CHECK_FALSE(mentions(svg, "nan"));
  CHECK_FALSE(mentions(svg, "inf"));
}
