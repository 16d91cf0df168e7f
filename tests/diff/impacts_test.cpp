// Impacts: their words, and their order.
#include <catch2/catch.hpp>

#include "elgen/diff.hpp"

using namespace elgen;

TEST_CASE("an impact is found by its word") {
  for (const Impact impact : {Impact::equal, Impact::values, Impact::breaks}) {
    CHECK(find_impact(impact_row(impact).word) == impact);
  }
  CHECK_FALSE(find_impact("worse"));
}

TEST_CASE("what breaks is worst") {
  CHECK(Impact::equal < Impact::values);
  CHECK(Impact::extended < Impact::different);
  CHECK(Impact::different < Impact::breaks);
}
