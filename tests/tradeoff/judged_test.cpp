// The order of rows, the front, and what is chosen.
#include <catch2/catch.hpp>

#include "tradeoff/tables.hpp"

using namespace elgen;
using namespace elgen::test;

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
