// A program run on canonical sums.
#include <catch2/catch.hpp>

#include "elgen/closed_forms.hpp"
#include "lower/read_program.hpp"

using namespace elgen;

namespace {

const std::string leaves = "parameters m\ncoordinates x y\n";

}  // namespace

TEST_CASE("sin^2 + cos^2 is 1") {
  const ClosedForms forms = present(testing::read_program(
      leaves +
      "function bias\n  0 = coordinate x\n  1 = sin 0\n  2 = multiply 1 1\n  3 = cos 0\n"
      "  4 = multiply 3 3\n  5 = add 2 4\n  result 1 1 = 5\n"));
  const auto& entry = forms.functions.at(0).fields.at(0).entries.at(0);
  REQUIRE(entry);
  CHECK(entry->numerator.size() == 1);
  CHECK(entry->numerator.begin()->first.empty());
}

TEST_CASE("every operation of a program") {
  const ClosedForms forms = present(testing::read_program(
      leaves +
      "function bias\n  0 = parameter m\n  1 = velocity x\n  2 = time\n  3 = negate 1\n"
      "  4 = subtract 0 3\n  5 = divide 4 0\n  6 = square_root 0\n  7 = atan2 2 6\n"
      "  8 = multiply 5 7\n  result 1 1 = 8\n"));
  const auto& entry = forms.functions[0].fields[0].entries[0];
  REQUIRE(entry);
  CHECK(entry->numerator.size() == 2);
}

TEST_CASE("what costs more than its budget is given up") {
  const Program program =
      testing::read_program(leaves +
                            "function bias\n  0 = coordinate x\n  1 = coordinate y\n  2 = add 0 1\n"
                            "  3 = multiply 2 2\n  4 = multiply 3 3\n  result 1 1 = 4\n");
  CHECK(present(program).functions[0].fields[0].entries[0]);
  CHECK_FALSE(present(program, {5, 5, 100}).functions[0].fields[0].entries[0]);
  CHECK_FALSE(present(program, {500, 500, 3}).functions[0].fields[0].entries[0]);
}
