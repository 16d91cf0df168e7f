// Scalars: types, kinds and names go together.
#include "elgen/scalars.hpp"

#include <catch2/catch.hpp>

using namespace elgen;

TEST_CASE("a row of the table stands at its kind") {
  for (const ScalarRow& row : scalar_table) CHECK(name_of(row.kind) == row.name);
  CHECK(name_of(scalar_kind<float>) == "float");
  CHECK(name_of(scalar_kind<double>) == "double");
  CHECK(name_of(scalar_kind<long double>) == "long double");
}
