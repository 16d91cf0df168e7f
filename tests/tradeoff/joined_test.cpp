// Tables of parts, joined, are the table of all.
#include <catch2/catch.hpp>

#include "tradeoff/tables.hpp"

using namespace elgen;
using namespace elgen::test;

namespace {

/// Every second row of the sample from `first` on.
TradeoffTable part_of(const TradeoffTable& all, std::size_t first,
                      std::vector<std::string> sentences) {
  TradeoffTable part = all;
  part.rows.clear();
  for (std::size_t i = first; i < all.rows.size(); i += 2) part.rows.push_back(all.rows[i]);
  part.sentences = std::move(sentences);
  return part;
}

}  // namespace

TEST_CASE("rows are in the order of the plan again, and judged alike") {
  TradeoffTable all = sample_table();
  for (std::size_t i = 0; i < all.rows.size(); ++i) all.rows[i].number = i;
  const TradeoffTable both = joined({part_of(all, 1, {}), part_of(all, 0, {})});
  REQUIRE(both.rows.size() == 5);
  for (std::size_t i = 0; i < 5; ++i) CHECK(both.rows[i].values == all.rows[i].values);
  CHECK(to_json(judged(both)) == to_json(judged(all)));
}

TEST_CASE("what several parts say is said once, after what is said of the dimensions") {
  const TradeoffTable all = sample_table();
  const TradeoffTable both =
      judged(joined({part_of(all, 0, {"no verlet"}), part_of(all, 1, {"no euler", "no verlet"})}));
  const std::vector<std::string> dimensions = judged(all).sentences;
  REQUIRE(both.sentences.size() == dimensions.size() + 2);
  CHECK(both.sentences.front() == dimensions.front());
  CHECK(both.sentences[dimensions.size()] == "no euler");
  CHECK(both.sentences.back() == "no verlet");
}
