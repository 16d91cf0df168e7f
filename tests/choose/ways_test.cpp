// The ways to write a closed form.
#include "choose/ways.hpp"

#include <algorithm>
#include <catch2/catch.hpp>

#include "lower/expression_leaves.hpp"

using namespace elgen;

namespace {

std::vector<std::string> texts(const std::vector<Collected>& ways) {
  std::vector<std::string> all;
  for (const Collected& way : ways) all.push_back(testing::texts_of(way.expressions).at(0));
  return all;
}

}  // namespace

TEST_CASE("people write no half angles, code does where they keep digits") {
  const ClosedForms forms = present(testing::program_of(testing::Texts{"a - a*cos(b)"}));
  const Fraction& entry = *forms.functions[0].fields[0].entries[0];
  const auto read = texts(collected_ways(forms.algebra, entry));
  CHECK(std::ranges::count(read, "a*(1 - cos(b))") > 0);
  CHECK(std::ranges::count(read, "2*a*sin(1/2*b)^2") == 0);
  const auto precise = texts(precise_ways(forms.algebra, entry));
  REQUIRE_FALSE(precise.empty());
  CHECK(std::ranges::count(precise, "2*a*sin(1/2*b)^2") == static_cast<long>(precise.size()));
}

TEST_CASE("lengths count signs and calls") {
  const Expressions sum = testing::expressions_of({"a + b"});
  CHECK(written_length(sum) == 1);
  CHECK(derived_way(sum).length == 1);
}

TEST_CASE("a root less what it is nearly, and what is nearly a root less the root") {
  const auto conjugates =
      with_conjugates(testing::expressions_of({"sqrt(a^2 + b^2) - a", "a - sqrt(a^2 + b^2)"}));
  REQUIRE(conjugates);
  CHECK(testing::texts_of(*conjugates) ==
        testing::Texts{"b^2/(a + sqrt(a^2 + b^2))", "-b^2/(a + sqrt(a^2 + b^2))"});
}

TEST_CASE("sums whose squares share nothing stay") {
  CHECK_FALSE(with_conjugates(
      testing::expressions_of({"sqrt(a^2 + b^2) - c", "sqrt(a^2 + b^2) + sqrt(a^2 + b^2)"})));
}
