// Rewritings of a closed form: readable rewritings, and precise ones, which lose fewer digits.
#include "forms/write/rewritings.hpp"

#include <algorithm>
#include <catch2/catch.hpp>

#include "forms/write/closed_graph.hpp"
#include "program/expression_leaves.hpp"

using namespace elgen;
using namespace elgen::test;

namespace {

std::vector<std::string> texts(const std::vector<CollectedForm>& rewritings) {
  std::vector<std::string> all;
  for (const CollectedForm& rewriting : rewritings) {
    all.push_back(texts_of(rewriting.expressions).at(0));
  }
  return all;
}

}  // namespace

TEST_CASE("readable forms have no half angles, precise forms do if they keep digits") {
  const ClosedForms forms = present(program_of(Texts{"a - a*cos(b)"}));
  const Fraction& entry = *forms.functions[0].fields[0].entries[0];
  const auto read = texts(rewritings_of(forms.algebra, entry).collected);
  CHECK(std::ranges::count(read, "a*(1 - cos(b))") > 0);
  CHECK(std::ranges::count(read, "2*a*sin(1/2*b)^2") == 0);
  const auto precise = texts(precise_rewritings(forms.algebra, entry));
  REQUIRE_FALSE(precise.empty());
  CHECK(std::ranges::count(precise, "2*a*sin(1/2*b)^2") == static_cast<long>(precise.size()));
}

TEST_CASE("the length of an expression counts signs and calls") {
  const Expressions sum = expressions_of({"a + b"});
  CHECK(written_length(sum) == 1);
  CHECK(derived_rewriting(sum).length == 1);
}

TEST_CASE("sums of sines and cosines in homogeneous terms") {
  struct TermsRow {
    const char* sum;
    const char* written;
  };
  const TermsRow row = GENERATE(values<TermsRow>({
      {"1 - cos(e)", "2*sin(1/2*e)^2"},
      {"1 + cos(e)", "2*cos(1/2*e)^2"},
      {"a + (b - a)*cos(e)^2", "a*sin(e)^2 + b*cos(e)^2"},
      // Terms without an angle stay separate.
      {"a + b - b*cos(e)^2", "a + b*sin(e)^2"},
      // A constant is not split between several angles.
      {"1 - cos(d) - cos(e)", "1 - cos(d) - cos(e)"},
      // Two sines or two cosines with equal factors become a product.
      {"sin(d) + sin(e)", "2*sin(1/2*(d + e))*cos(1/2*(d - e))"},
      {"sin(d) - sin(e)", "2*sin(1/2*(d - e))*cos(1/2*(d + e))"},
      {"cos(d) + cos(e)", "2*cos(1/2*(d + e))*cos(1/2*(d - e))"},
      {"cos(d) - cos(e)", "-2*sin(1/2*(d + e))*sin(1/2*(d - e))"},
      // High multiples of an angle are not expanded.
      {"cos(40*e) + 1 - cos(e)", "none"},
  }));
  INFO(row.sum);
  const ClosedForms forms = present(program_of(Texts{row.sum}));
  Expressions expressions;
  const auto value =
      build_closed_graph(expressions.graph, forms.algebra, *forms.functions[0].fields[0].entries[0],
                         {Trigonometry::homogeneous, Grouping::none}, 100);
  if (value) expressions.values = {*value};
  CHECK((value ? texts_of(expressions).at(0) : "none") == row.written);
}
