// The way to write an entry that keeps its digits.
#include "choose/precise.hpp"

#include <catch2/catch.hpp>

#include "lower/expression_leaves.hpp"
#include "lower/read_program.hpp"

using namespace elgen;

namespace {

/// What is taken for instruction `entry` of a program over a to e, 0 to 4.
std::string precise(const std::string& instructions, int entry) {
  const Program program = testing::read_program(
      "coordinates a b c d e\nfunction bias\n  0 = coordinate a\n  1 = coordinate b\n"
      "  2 = coordinate c\n  3 = coordinate d\n  4 = coordinate e\n" +
      instructions + "  result 1 1 = " + std::to_string(entry) + "\n");
  const ClosedForms forms = present(program);
  const Function& function = program.functions[0];
  const ExtremePoints points = extreme_points(program, Preference::accuracy);
  const auto derived = as_derived(program, function, function.fields[0].entries[0]);
  const auto way = more_precise(forms.algebra, *forms.functions[0].fields[0].entries[0],
                                derived ? &*derived : nullptr, {.loss = 1e12}, points);
  return way ? testing::texts_of(*way).at(0) : "none";
}

}  // namespace

TEST_CASE("half angles for 1 - cos") {
  CHECK(precise("  5 = cos 4\n  6 = constant 1\n  7 = subtract 6 5\n", 7) == "2*sin(1/2*e)^2");
}

TEST_CASE("the conjugate of a difference with a root") {
  CHECK(precise("  5 = multiply 0 0\n  6 = multiply 1 1\n  7 = add 5 6\n  8 = square_root 7\n"
                "  9 = abs 0\n  10 = subtract 8 9\n",
                10) != "none");
}

TEST_CASE("the shortest where all keep their digits") {
  CHECK(precise("  5 = multiply 0 1\n  6 = multiply 0 2\n  7 = add 5 6\n", 7) == "a*(b + c)");
}
