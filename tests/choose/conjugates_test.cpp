// Differences with a root, by their conjugates.
#include "choose/conjugates.hpp"

#include <catch2/catch.hpp>

#include "lower/expression_leaves.hpp"

using namespace elgen;
using testing::expressions_of;
using testing::Texts;

TEST_CASE("a root less what it is nearly, and what is nearly a root less the root") {
  const auto conjugates =
      with_conjugates(expressions_of({"sqrt(a^2 + b^2) - a", "a - sqrt(a^2 + b^2)"}));
  REQUIRE(conjugates);
  CHECK(testing::texts_of(*conjugates) ==
        Texts{"b^2/(a + sqrt(a^2 + b^2))", "-b^2/(a + sqrt(a^2 + b^2))"});
}

TEST_CASE("sums whose squares share nothing stay") {
  CHECK_FALSE(with_conjugates(
      expressions_of({"sqrt(a^2 + b^2) - c", "sqrt(a^2 + b^2) + sqrt(a^2 + b^2)"})));
}
