// The way to write an entry that keeps its digits.
#include "choose/precise.hpp"

#include <catch2/catch.hpp>

#include "lower/expression_leaves.hpp"

using namespace elgen;

namespace {

std::string precise(const std::string& text) {
  const Program program = testing::program_of(testing::Texts{text});
  const ClosedForms forms = present(program);
  const Function& function = program.functions[0];
  const ExtremePoints points = extreme_points(program, Preference::accuracy);
  const auto derived = as_derived(program, function, function.fields[0].entries[0]);
  const auto way = more_precise(forms.algebra, *forms.functions[0].fields[0].entries[0],
                                derived ? &*derived : nullptr, {.loss = 1e12}, points);
  return way ? testing::texts_of(*way).at(0) : "none";
}

}  // namespace

TEST_CASE("half angles, conjugates, and the shortest where all keep their digits") {
  CHECK(precise("1 - cos(e)") == "2*sin(1/2*e)^2");
  CHECK(precise("sqrt(a^2 + b^2) - abs(a)") != "none");
  CHECK(precise("a*b + a*c") == "a*(b + c)");
}
