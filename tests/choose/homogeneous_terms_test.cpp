// Sums that do not cancel where the sine or the cosine of an angle is 1.
#include "choose/homogeneous_terms.hpp"

#include <catch2/catch.hpp>

#include "choose/closed_graph.hpp"
#include "lower/expression_leaves.hpp"
#include "lower/read_program.hpp"

using namespace elgen;

namespace {

/// Instruction `entry` of a program over a to e, 0 to 4, and cos(e), 5, in homogeneous terms.
std::string written(const std::string& instructions, int entry) {
  const ClosedForms forms = present(testing::read_program(
      "coordinates a b c d e\nfunction bias\n  0 = coordinate a\n  1 = coordinate b\n"
      "  2 = coordinate c\n  3 = coordinate d\n  4 = coordinate e\n  5 = cos 4\n"
      "  6 = constant 1\n" +
      instructions + "  result 1 1 = " + std::to_string(entry) + "\n"));
  Expressions expressions;
  const auto value =
      closed_graph(expressions.graph, forms.algebra, *forms.functions[0].fields[0].entries[0],
                   {Trigonometry::homogeneous, Grouping::none}, 100);
  if (!value) return "none";
  expressions.values = {*value};
  return testing::texts_of(expressions).at(0);
}

}  // namespace

TEST_CASE("1 - cos(e) and 1 + cos(e) are squares of half angles") {
  CHECK(written("  7 = subtract 6 5\n", 7) == "2*sin(1/2*e)^2");
  CHECK(written("  7 = add 6 5\n", 7) == "2*cos(1/2*e)^2");
}

TEST_CASE("a + (b - a) cos(e)^2 is a sin(e)^2 + b cos(e)^2") {
  CHECK(written("  7 = subtract 1 0\n  8 = multiply 7 5\n  9 = multiply 8 5\n  10 = add 0 9\n",
                10) == "a*sin(e)^2 + b*cos(e)^2");
}

TEST_CASE("what has no angle stays beside what has") {
  CHECK(written("  7 = multiply 5 5\n  8 = multiply 1 7\n  9 = subtract 1 8\n  10 = add 0 9\n",
                10) == "a + b*sin(e)^2");
}

TEST_CASE("a constant of several angles is not divided among them") {
  CHECK(written("  7 = cos 3\n  8 = add 7 5\n  9 = subtract 6 8\n", 9) == "1 - cos(d) - cos(e)");
}

TEST_CASE("two sines or cosines of as much are one product") {
  const std::string sines = "  7 = sin 3\n  8 = sin 4\n";
  CHECK(written(sines + "  9 = add 7 8\n", 9) == "2*sin(1/2*(d + e))*cos(1/2*(d - e))");
  CHECK(written(sines + "  9 = subtract 7 8\n", 9) == "2*sin(1/2*(d - e))*cos(1/2*(d + e))");
  CHECK(written("  7 = cos 3\n  8 = add 7 5\n", 8) == "2*cos(1/2*(d + e))*cos(1/2*(d - e))");
  CHECK(written("  7 = cos 3\n  8 = subtract 7 5\n", 8) == "-2*sin(1/2*(d + e))*sin(1/2*(d - e))");
}

TEST_CASE("high multiples are not written out") {
  CHECK(written("  7 = constant 40\n  8 = multiply 7 4\n  9 = cos 8\n  10 = subtract 6 5\n"
                "  11 = add 9 10\n",
                11) == "none");
}
