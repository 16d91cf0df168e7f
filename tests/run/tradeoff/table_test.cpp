// Tables: ranks, order of rows, the Pareto front, the picked design, and all output formats. Costs
// and errors are invented, so nothing is measured.
#include <tinyxml2.h>

#include <catch2/catch.hpp>
#include <cmath>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <vector>

#include "elgen/tradeoff.hpp"
#include "support/shell.hpp"

using namespace elgen;
using namespace elgen::test;

namespace {

/// A row whose cost has a noise of 5 %. In packs, a call for a single state costs 5 `cost`. `noise`
/// is the worst error divided by the least error.
TradeoffRow row_of(std::vector<std::string> values, double cost, double error, double noise = 1) {
  const double call = values.back() == "packs" ? 5 * cost : cost;
  return {.values = std::move(values),
          .cost = {cost, 0.05},
          .call_cost = {call, 0.05},
          .error = {error, error / 4, error / noise}};
}

/// A row whose error is below the error `bound` of the reference.
TradeoffRow row_below(std::vector<std::string> values, double cost, double bound) {
  TradeoffRow row = row_of(std::move(values), cost, bound);
  row.is_below_reference = true;
  row.error.least = 0;
  return row;
}

TradeoffRow failed_row(std::vector<std::string> values, std::string why) {
  return {.values = std::move(values), .failure = std::move(why)};
}

/// A table in the order of a plan: two scalar types, each singly and in packs, and a failed row.
TradeoffTable sample_table() {
  return {.model = "arm",
          .subject = "gravity",
          .cost = "ns per state",
          .call_cost = "ns per call",
          .error = "errors, relative",
          .dimensions = {"scalar", "batch"},
          .rows = {row_of({"double", "one"}, 40, 1e-16), row_of({"double", "packs"}, 8, 2e-16),
                   row_of({"float", "one"}, 39.5, 1e-7), row_of({"float", "packs"}, 4, 2e-7),
                   failed_row({"half", "one"}, "E709: \"c++\" exits 1")},
          .machine = {.compiler = "g++ 12", .processor = "a processor"}};
}

struct Figures {
  double cost;
  double error;
  double noise = 1;
};

/// The first values of the rows with their ranks, and a star on the front: "b1* a1 c2".
std::string order_in(TradeoffTable table) {
  std::string text;
  for (const TradeoffRow& row : rank_rows(std::move(table)).rows) {
    text += (text.empty() ? "" : " ") + row.values.front() + std::to_string(row.rank);
    if (row.is_on_pareto_front) text += '*';
  }
  return text;
}

/// The order of rows named "a", "b", ... with these figures.
std::string order_of(const std::vector<Figures>& rows) {
  TradeoffTable table{.dimensions = {"name"}};
  for (const auto& [cost, error, noise] : rows) {
    const auto name = static_cast<char>('a' + table.rows.size());
    table.rows.push_back(row_of({std::string(1, name)}, cost, error, noise));
  }
  return order_in(std::move(table));
}

}  // namespace

TEST_CASE("rows are sorted by cost, failed rows are last, and undominated rows are the front") {
  const TradeoffTable table = rank_rows(sample_table());
  REQUIRE(table.rows.size() == 5);
  CHECK(name_of(table.rows[0]) == "float, packs");
  CHECK(name_of(table.rows[1]) == "double, packs");
  CHECK(name_of(table.rows[2]) == "double, one");
  CHECK(name_of(table.rows[3]) == "float, one");
  CHECK(name_of(table.rows[4]) == "half, one");
  std::vector<bool> front;
  std::vector<std::size_t> ranks;
  for (const TradeoffRow& row : table.rows) {
    front.push_back(row.is_on_pareto_front);
    ranks.push_back(row.rank);
  }
  CHECK(front == std::vector<bool>{true, true, true, false, false});
  CHECK(ranks == std::vector<std::size_t>{1, 2, 3, 3, 0});
}

TEST_CASE("rows that cost the same share a rank, sorted by error") {
  CHECK(order_of({{10, 1e-7}, {10.4, 1e-9}}) == "b1* a1");
  CHECK(order_of({{10, 1e-9}, {10.4, 1e-7}}) == "a1* b1");
  CHECK(order_of({{10, 1e-7}, {12, 1e-9}}) == "a1* b2*");
}

TEST_CASE("costs of a rank are close to its least cost, and do not form a chain") {
  CHECK(order_of({{11.5, 1e-9}, {10, 1e-7}, {10.8, 1e-8}}) == "c1* b1 a2*");
  // Each cost is 1.09 times the cost before it, so two costs share a rank, and three do not.
  TradeoffTable table;
  for (double cost = 611; cost < 10'700; cost *= 1.09) {
    table.rows.push_back(row_of({"a"}, cost, 1e-7));
  }
  table = rank_rows(std::move(table));
  REQUIRE(table.rows.size() == 34);
  for (std::size_t i = 0; i < 34; ++i) CHECK(table.rows[i].rank == 1 + i / 2);
}

TEST_CASE("only the noise of the cheapest row lets more expensive rows share its rank") {
  const auto ranked = [](double noise_of_first, double noise_of_second) {
    TradeoffTable table{.rows = {row_of({"a"}, 10, 1e-7), row_of({"b"}, 12, 1e-9)}};
    table.rows[0].cost.noise = noise_of_first;
    table.rows[1].cost.noise = noise_of_second;
    return order_in(std::move(table));
  };
  CHECK(ranked(0.21, 0) == "b1* a1");
  CHECK(ranked(0.19, 9) == "a1* b2*");
}

TEST_CASE("of equally good designs only the plan's first is on the front") {
  CHECK(order_of({{5.1, 1e-3}, {5, 1e-3}, {4.9, 1e-3}}) == "a1* b1 c1");
}

TEST_CASE("costs within a factor of 1.1 share a rank, even without noise") {
  const auto ranked = [](double dearer) {
    TradeoffTable table{.rows = {row_of({"a"}, 10, 1e-7), row_of({"b"}, dearer, 1e-9)}};
    for (TradeoffRow& row : table.rows) row.cost.noise = 0;
    return order_in(std::move(table));
  };
  CHECK(ranked(10.9) == "b1* a1");
  CHECK(ranked(11.1) == "a1* b2*");
}

TEST_CASE("of errors equal within their noise, the cheaper row has the star") {
  CHECK(order_of({{1, 1e-7, 1.2}, {2, 0.9e-7, 1.3}}) == "a1* b2");
  CHECK(order_of({{1, 1e-7, 1.2}, {2, 0.7e-7, 1.3}}) == "a1* b2*");
  CHECK(order_of({{1, 1e-7, 4}, {2, 0.7e-7, 1.3}}) == "a1* b2");
  // The noise of an error ranges from its least to its worst value; comparisons use the worst.
  CHECK(order_of({{1, 1e-7, 1.2}, {2, 0.9e-7, 100}}) == "a1* b2");
}

TEST_CASE("errors within a factor of 1.1 are equal even without noise") {
  CHECK(order_of({{1, 1e-7}, {2, 0.95e-7}}) == "a1* b2");
  CHECK(order_of({{1, 1e-7}, {2, 0.85e-7}}) == "a1* b2*");
}

TEST_CASE("errors are compared only with rows on the front") {
  CHECK(order_of({{1, 1e-7}, {2, 0.95e-7, 100}, {3, 0.87e-7}}) == "a1* b2 c3*");
  CHECK(order_of({{1, 1.5, 100}, {2, 0.9}}) == "a1 b2*");
}

TEST_CASE("a row with an error above 100 % is not on the front") {
  CHECK(order_of({{1, INFINITY}, {2, 1.1}, {3, 1}, {4, 0.5}}) == "a1 b2 c3* d4*");
  CHECK(order_of({{1, 1.1}}) == "a1");
}

TEST_CASE("the cheapest row below the reference ends the front, and may be picked") {
  TradeoffTable table{
      .cost = "ns",
      .dimensions = {"name"},
      .rows = {row_of({"a"}, 1, 1e-7), row_of({"b"}, 2, 1e-12), row_below({"c"}, 4, 1e-13),
               row_of({"d"}, 8, 1e-9), row_below({"e"}, 16, 1e-13)}};
  table.max_error = 5e-13;
  table = rank_rows(std::move(table));
  CHECK(order_in(table) == "a1* b2* c3* d4 e5");
  const std::string text = to_text(table);
  CHECK(mentions(text, "* 3     c     4   5.0 %  below 1.0e-13\n"));
  CHECK(mentions(text, "\ncheapest within 5e-13: c; 4 ns, error below 1.0e-13\n"));
  const auto json = nlohmann::json::parse(to_json(table))["designs"];
  CHECK(json[2]["error"]["below_reference"] == true);
  CHECK(json[2]["error"]["worst"] == 1e-13);
  CHECK_FALSE(json[1]["error"].contains("below_reference"));
}

TEST_CASE("a row below the reference has no star if a cheaper row may be as accurate") {
  TradeoffTable table{.rows = {row_of({"a"}, 1, 1.05e-13, 1e9), row_below({"b"}, 2, 1e-13)}};
  CHECK(order_in(std::move(table)) == "a1* b2");
}

TEST_CASE("cheapest_within and most_accurate select rows") {
  const TradeoffTable table = rank_rows(sample_table());
  CHECK(name_of(*cheapest_accurate_row(table, 1e-6)) == "float, packs");
  CHECK(name_of(*cheapest_accurate_row(table, 1e-15)) == "double, packs");
  CHECK(cheapest_accurate_row(table, 1e-17) == nullptr);
  CHECK(name_of(*most_accurate_row(table)) == "double, one");
  CHECK(most_accurate_row(TradeoffTable{.rows = {failed_row({}, "E705")}}) == nullptr);
}

TEST_CASE("of designs with equal cost the most accurate is picked") {
  TradeoffTable table = rank_rows(
      {.dimensions = {"name"}, .rows = {row_of({"a"}, 10, 1e-7), row_of({"b"}, 10.4, 1e-9)}});
  CHECK(picked_row(table) == nullptr);
  table.max_error = 1e-6;
  CHECK(name_of(*picked_row(table)) == "b");
  table.max_error = 1e-12;
  CHECK(picked_row(table) == nullptr);
}

TEST_CASE("text has columns, stars on the front, and the reasons of failures") {
  TradeoffTable table = rank_rows(sample_table());
  table.sentences = {"one", "two"};
  table.max_error = 1e-6;
  CHECK(to_text(table) == R"(arm, gravity: errors, relative

  rank  scalar  batch  ns per state  noise  ns per call  worst error  median error
* 1     float   packs  4             5.0 %  20           2.0e-07      5.0e-08
* 2     double  packs  8             5.0 %  40           2.0e-16      5.0e-17
* 3     double  one    40            5.0 %  40           1.0e-16      2.5e-17
  3     float   one    39.5          5.0 %  39.5         1.0e-07      2.5e-08
        half    one    E709: "c++" exits 1

a time is the least of many rounds; its noise is the relative difference of the least times of even and odd rounds
designs of one rank cost the same: at most 1.1 times the cheapest of the rank, or within its noise
*: more accurate than every * above, by a factor of 1.1 and beyond the noise of both
one
two
measured on a processor, g++ 12
cheapest within 1e-06: float, packs; 4 ns per state, 20 ns per call, error 2.0e-07
)");
}

TEST_CASE("without call costs there is no column, and without a pick there is no line") {
  TradeoffTable table = rank_rows({.model = "arm",
                                   .subject = "2 s in time",
                                   .cost = "ns per run",
                                   .error = "errors",
                                   .dimensions = {"method"},
                                   .rows = {row_of({"rk4"}, 40, 1e-5)},
                                   .machine = {.compiler = "g++ 12", .processor = "a processor"}});
  const std::string text = R"(arm, 2 s in time: errors

  rank  method  ns per run  noise  worst error  median error
* 1     rk4     40          5.0 %  1.0e-05      2.5e-06

a time is the least of many rounds; its noise is the relative difference of the least times of even and odd rounds
designs of one rank cost the same: at most 1.1 times the cheapest of the rank, or within its noise
*: more accurate than every * above, by a factor of 1.1 and beyond the noise of both
measured on a processor, g++ 12
)";
  CHECK(to_text(table) == text);
  table.max_error = 1e-9;
  CHECK(to_text(table) == text);
  table.max_error = 1e-4;
  CHECK(to_text(table) == text + "cheapest within 0.0001: rk4; 40 ns per run, error 1.0e-05\n");
}

TEST_CASE("JSON has a design for every row") {
  TradeoffTable table = rank_rows(sample_table());
  table.sentences = {"one"};
  const auto json = nlohmann::json::parse(to_json(table));
  CHECK(json["model"] == "arm");
  REQUIRE(json["designs"].size() == 5);
  const auto& first = json["designs"][0];
  CHECK(first["design"]["scalar"] == "float");
  CHECK(first["rank"] == 1);
  CHECK(first["cost"]["least"] == 4);
  CHECK(first["cost"]["noise"] == 0.05);
  CHECK(first["call_cost"]["least"] == 20);
  CHECK(first["error"]["worst"] == 2e-7);
  CHECK(first["error"]["least"] == 2e-7);
  CHECK(first["front"] == true);
  CHECK(json["designs"][4]["failure"] == "E709: \"c++\" exits 1");
  CHECK_FALSE(json["designs"][4].contains("cost"));
  CHECK(json["sentences"].size() == 1);
  CHECK(json["call_cost"] == "ns per call");
  CHECK_FALSE(json.contains("pick"));
}

TEST_CASE("JSON has the picked row, or null") {
  TradeoffTable table = rank_rows(sample_table());
  table.max_error = 1e-15;
  const auto json = nlohmann::json::parse(to_json(table));
  CHECK(json["max_error"] == 1e-15);
  CHECK(json["pick"] == json["designs"][1]);
  table.max_error = 1e-30;
  CHECK(nlohmann::json::parse(to_json(table))["pick"].is_null());
}

TEST_CASE("an infinite error is null in JSON") {
  const TradeoffTable table{.dimensions = {"a"}, .rows = {row_of({"1"}, 1, INFINITY)}};
  CHECK(nlohmann::json::parse(to_json(table))["designs"][0]["error"]["worst"].is_null());
}

TEST_CASE("CSV quotes cells with quotes, and failed rows have no numbers") {
  TradeoffTable table = rank_rows(sample_table());
  table.rows.erase(table.rows.begin() + 1, table.rows.end() - 1);
  table.max_error = 1e-6;
  CHECK(
      to_csv(table) ==
      "scalar,batch,rank,cost,cost_noise,call_cost,worst_error,median_error,least_error,front,pick,"
      "failure\n"
      "float,packs,1,4,0.05,20,2e-07,5e-08,2e-07,1,1,\n"
      "half,one,,,,,,,,0,0,\"E709: \"\"c++\"\" exits 1\"\n");
}

TEST_CASE("a plot is XML with every measured design, and a staircase of the Pareto front") {
  const std::string svg = to_svg(rank_rows(sample_table()));
  tinyxml2::XMLDocument document;
  REQUIRE(document.Parse(svg.c_str()) == tinyxml2::XML_SUCCESS);
  CHECK(count(svg, "fill=\"black\"") == 2 * 3);
  CHECK(count(svg, "transform=") == 2 * 4);
  CHECK(mentions(svg, ">1  float, packs<"));
  CHECK(mentions(svg, "<path d=\"M226.5 95.4H304.8V473.4H486.5V486.0\" fill=\"none\""));
  CHECK(mentions(svg, "arm, gravity"));
  CHECK_FALSE(mentions(svg, "E709"));
}

TEST_CASE("a plot labels its axes and dimensions, and explains its marks and lines") {
  TradeoffTable table = sample_table();
  const std::string svg = to_svg(rank_rows(table));
  for (const char* const text :
       {">arm, gravity: errors, relative<", ">worst error, relative<", ">cost [ns per state]<",
        ">scalar, batch<", ">3  double, one state at a time<", ">black: the front", ">line: "}) {
    INFO(text);
    CHECK(mentions(svg, text));
  }
  CHECK_FALSE(mentions(svg, ">grey: "));
  table.rows[0] = row_below({"double", "one"}, 40, 1e-15);
  table.rows[1] = row_below({"double", "packs"}, 8, 1e-15);
  const std::string with_grey = to_svg(rank_rows(table));
  CHECK(mentions(with_grey, ">grey: "));
  CHECK(count(with_grey, "fill=\"#bbb\"") == 2);
}

TEST_CASE("marks of the front are drawn last, so that no other mark covers them") {
  const std::string svg = to_svg(rank_rows(
      {.dimensions = {"name"}, .rows = {row_of({"a"}, 10, 1e-7), row_of({"b"}, 10, 1e-7)}}));
  CHECK(svg.rfind("fill=\"black\"") > svg.rfind("fill=\"white\""));
}

TEST_CASE("shapes distinguish the values of the first dimension") {
  const std::string svg = to_svg(rank_rows(sample_table()));
  CHECK(count(svg, "d=\"M-5 0A") == 4);
  CHECK(count(svg, "d=\"M-4.5 ") == 4);
}

TEST_CASE("errors without a logarithm stay inside the plot") {
  const std::string svg = to_svg(rank_rows(
      {.dimensions = {"a"}, .rows = {row_of({"1"}, 1, 0), row_of({"2"}, 0.5, INFINITY)}}));
  CHECK_FALSE(mentions(svg, "nan"));
  CHECK_FALSE(mentions(svg, "inf"));
}
