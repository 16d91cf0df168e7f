// Every limit has one row.
#include "elgen/limits.hpp"

#include <catch2/catch.hpp>
#include <set>

using namespace elgen;

TEST_CASE("the table names every limit once") {
  std::set<std::string_view> names;
  Limits limits;
  for (const LimitRow& row : limit_table()) {
    CHECK(names.insert(row.name).second);
    CHECK_FALSE(row.doc.empty());
    limits.*row.member = 0;
  }
  // All members are 64-bit numbers: a limit without a row would survive.
  CHECK(sizeof(Limits) == limit_table().size() * sizeof(std::uint64_t));
}
