// A table for people.
#include <catch2/catch.hpp>

#include "tradeoff/tables.hpp"

using namespace elgen;
using namespace elgen::test;

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
