// Sums that do not cancel where the sine or the cosine of an angle is 1.
#include "choose/homogeneous_terms.hpp"

#include <catch2/catch.hpp>

#include "choose/closed_graph.hpp"
#include "lower/expression_leaves.hpp"

using namespace elgen;

TEST_CASE("sums of sines and cosines in homogeneous terms") {
  struct TermsRow {
    const char* sum;
    const char* written;
  };
  const TermsRow row = GENERATE(values<TermsRow>({
      {"1 - cos(e)", "2*sin(1/2*e)^2"},
      {"1 + cos(e)", "2*cos(1/2*e)^2"},
      {"a + (b - a)*cos(e)^2", "a*sin(e)^2 + b*cos(e)^2"},
      // Terms without an angle stay beside the others.
      {"a + b - b*cos(e)^2", "a + b*sin(e)^2"},
      // A constant of several angles is not divided among them.
      {"1 - cos(d) - cos(e)", "1 - cos(d) - cos(e)"},
      // Two sines or cosines of as much are one product.
      {"sin(d) + sin(e)", "2*sin(1/2*(d + e))*cos(1/2*(d - e))"},
      {"sin(d) - sin(e)", "2*sin(1/2*(d - e))*cos(1/2*(d + e))"},
      {"cos(d) + cos(e)", "2*cos(1/2*(d + e))*cos(1/2*(d - e))"},
      {"cos(d) - cos(e)", "-2*sin(1/2*(d + e))*sin(1/2*(d - e))"},
      // High multiples are not written out.
      {"cos(40*e) + 1 - cos(e)", "none"},
  }));
  INFO(row.sum);
  const ClosedForms forms = present(testing::program_of(testing::Texts{row.sum}));
  Expressions expressions;
  const auto value =
      closed_graph(expressions.graph, forms.algebra, *forms.functions[0].fields[0].entries[0],
                   {Trigonometry::homogeneous, Grouping::none}, 100);
  if (value) expressions.values = {*value};
  CHECK((value ? testing::texts_of(expressions).at(0) : "none") == row.written);
}
