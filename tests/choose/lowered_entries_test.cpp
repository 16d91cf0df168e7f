// Entries as instructions.
#include "choose/lowered_entries.hpp"

#include <catch2/catch.hpp>

#include "elgen/render.hpp"
#include "lower/read_program.hpp"

using namespace elgen;

namespace {

/// (a + b) c and (a + b) d
const char* two_products =
    "coordinates a b c d e\nfunction bias\n  0 = coordinate a\n  1 = coordinate b\n"
    "  2 = coordinate c\n  3 = coordinate d\n  4 = add 0 1\n  5 = multiply 4 2\n"
    "  6 = multiply 4 3\n  result 2 1 = 5 6\n";

struct Lowered {
  Program program = testing::read_program(two_products);
  Function shape = program.functions[0];
  ClosedForms forms = present(program);
  ReadableEntries entries =
      read_entries({program, shape, forms, forms.functions[0]}, mixed_points(program.leaves));
};

}  // namespace

TEST_CASE("together they share what they have in common") {
  Lowered l;
  const Function function =
      lowered_together(l.entries, l.shape, l.program, Splits::sums_and_differences);
  CHECK(function.form == Form::closed);
  CHECK(count_operations(function).add == 1);
}

TEST_CASE("one by one they share nothing") {
  Lowered l;
  const Function function = lowered_one_by_one(l.entries, l.shape, l.program);
  CHECK(count_operations(function).add == 2);
  REQUIRE(function.fields.size() == 1);
  CHECK(function.fields[0].entries.size() == 2);
}

TEST_CASE("a rewritten entry is code, whichever is cheaper") {
  Lowered l;
  l.entries[0]->is_rewritten = true;
  l.entries[0]->compact.values = {l.entries[0]->compact.graph.leaf(Opcode::coordinate, 4)};
  const Function function =
      lowered_together(l.entries, l.shape, l.program, Splits::sums_and_differences);
  l.program.functions = {function};
  CHECK(equations(l.program, function).entries.at(0).at(0) == "e");
}
