// Differences with a root, by their conjugates.
#include "choose/conjugates.hpp"

#include <catch2/catch.hpp>

#include "lower/expression_leaves.hpp"

using namespace elgen;

namespace {

/// sqrt(a^2 + b^2)
Ref length(testing::ExpressionLeaves& l) {
  return l.graph.square_root(
      l.graph.sum({l.graph.product({{l.a, 2}}), l.graph.product({{l.b, 2}})}));
}

}  // namespace

TEST_CASE("a root less what it is nearly") {
  testing::ExpressionLeaves l;
  const Ref difference = l.graph.sum({length(l), -l.a});
  l.expressions.values = {difference};
  const auto conjugate = with_conjugates(l.expressions);
  REQUIRE(conjugate);
  CHECK(testing::texts_of(*conjugate).at(0) == "b^2/(a + sqrt(a^2 + b^2))");
}

TEST_CASE("what is nearly a root less the root") {
  testing::ExpressionLeaves l;
  l.expressions.values = {l.graph.sum({l.a, -length(l)})};
  const auto conjugate = with_conjugates(l.expressions);
  REQUIRE(conjugate);
  CHECK(testing::texts_of(*conjugate).at(0) == "-b^2/(a + sqrt(a^2 + b^2))");
}

TEST_CASE("sums whose squares share nothing stay") {
  testing::ExpressionLeaves l;
  l.expressions.values = {l.graph.sum({length(l), -l.c}), l.graph.sum({length(l), length(l)})};
  CHECK_FALSE(with_conjugates(l.expressions));
}
