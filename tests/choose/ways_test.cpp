// The ways to write a closed form.
#include "choose/ways.hpp"

#include <algorithm>
#include <catch2/catch.hpp>

#include "lower/expression_leaves.hpp"
#include "lower/read_program.hpp"

using namespace elgen;

namespace {

/// a - a cos(b)
ClosedForms form() {
  return present(testing::read_program(
      "coordinates a b c d e\nfunction bias\n  0 = coordinate a\n  1 = coordinate b\n  2 = cos 1\n"
      "  3 = multiply 0 2\n  4 = subtract 0 3\n  result 1 1 = 4\n"));
}

std::vector<std::string> texts(const std::vector<Collected>& ways) {
  std::vector<std::string> all;
  for (const Collected& way : ways) all.push_back(testing::texts_of(way.expressions).at(0));
  return all;
}

}  // namespace

TEST_CASE("people write no half angles, code does where they keep digits") {
  const ClosedForms forms = form();
  const Fraction& entry = *forms.functions[0].fields[0].entries[0];
  const auto read = texts(collected_ways(forms.algebra, entry));
  CHECK(std::ranges::count(read, "a*(1 - cos(b))") > 0);
  CHECK(std::ranges::count(read, "2*a*sin(1/2*b)^2") == 0);
  const auto precise = texts(precise_ways(forms.algebra, entry));
  REQUIRE_FALSE(precise.empty());
  CHECK(std::ranges::count(precise, "2*a*sin(1/2*b)^2") == static_cast<long>(precise.size()));
}

TEST_CASE("lengths count signs and calls") {
  testing::ExpressionLeaves l;
  l.expressions.values = {l.graph.sum({l.a, l.b})};
  CHECK(written_length(l.expressions) == 1);
  CHECK(derived_way(l.expressions).length == 1);
}
