#include "lower/graph/angle_sums.hpp"

#include <catch2/catch.hpp>

#include "lower/expression_leaves.hpp"

using namespace elgen;
using testing::texts_of;

namespace {

Ref sine(testing::ExpressionLeaves& l, Ref x) { return l.graph.call(FunctionId::sin, {x}); }
Ref cosine(testing::ExpressionLeaves& l, Ref x) { return l.graph.call(FunctionId::cos, {x}); }

}  // namespace

TEST_CASE("a sum of angles that occur is taken apart") {
  testing::ExpressionLeaves l;
  const Ref sum = l.graph.sum({l.a, l.b});
  l.expressions.values = {cosine(l, sum), sine(l, sum), cosine(l, l.a), sine(l, l.b)};
  const auto expanded = expand_angle_sums(l.expressions);
  REQUIRE(expanded);
  CHECK(texts_of(*expanded) == std::vector<std::string>{"-(sin(a)*sin(b) - cos(a)*cos(b))",
                                                        "sin(a)*cos(b) + sin(b)*cos(a)", "cos(a)",
                                                        "sin(b)"});
}

TEST_CASE("differences and multiples are sums too, but for exact multiples of a leaf") {
  testing::ExpressionLeaves l;
  const Ref difference = l.graph.sum({l.a, -l.b});
  const Ref twice = l.graph.product({{l.graph.rational(2)}, {l.a}});
  const Ref thrice = l.graph.product({{l.graph.rational(3)}, {l.a}});
  l.expressions.values = {sine(l, difference), cosine(l, twice), sine(l, l.a), sine(l, l.b),
                          cosine(l, thrice)};
  const auto expanded = expand_angle_sums(l.expressions);
  REQUIRE(expanded);
  CHECK(texts_of(*expanded) == std::vector<std::string>{"sin(a)*cos(b) - sin(b)*cos(a)", "cos(2*a)",
                                                        "sin(a)", "sin(b)",
                                                        "-(sin(a)*sin(2*a) - cos(a)*cos(2*a))"});
}

TEST_CASE("differences stay whole where they may be small") {
  testing::ExpressionLeaves l;
  const Ref difference = l.graph.sum({l.a, -l.b});
  l.expressions.values = {sine(l, difference), sine(l, l.a), sine(l, l.b)};
  CHECK(expand_angle_sums(l.expressions, Splits::sums_and_differences));
  CHECK_FALSE(expand_angle_sums(l.expressions, Splits::sums));
}

TEST_CASE("an angle is no sum of parts in which something cancels") {
  testing::ExpressionLeaves l;
  const Ref five = l.graph.product({{l.graph.rational(5)}, {l.c}});
  const Ref first = l.graph.sum({l.a, -l.b});
  const Ref second = l.graph.sum({l.b, five});
  const Ref sum = l.graph.sum({l.a, five});
  l.expressions.values = {cosine(l, sum), sine(l, first), cosine(l, second)};
  CHECK_FALSE(expand_angle_sums(l.expressions));
}

TEST_CASE("an angle whose parts do not occur stays") {
  testing::ExpressionLeaves l;
  const Ref sum = l.graph.sum({l.a, l.b});
  l.expressions.values = {cosine(l, sum), sine(l, l.a)};
  CHECK_FALSE(expand_angle_sums(l.expressions));
}

TEST_CASE("a chain of splits grows with its length, not with its number of paths") {
  testing::ExpressionLeaves l;
  // S_k = S_(k-1) + x^k, each part an angle too: 2^19 paths lead from the last to the first.
  constexpr int length = 20;
  Ref sum = l.a;
  l.expressions.values = {cosine(l, l.a)};
  for (int k = 1; k < length; ++k) {
    const Ref joint = l.graph.product({{l.b, k}});
    sum = l.graph.sum({sum, joint});
    l.expressions.values.push_back(cosine(l, joint));
    l.expressions.values.push_back(cosine(l, sum));
  }
  const auto expanded = expand_angle_sums(l.expressions);
  REQUIRE(expanded);
  // Of each link two sums of two products, and the four calls they are made of.
  CHECK(expanded->graph.size() < 12 * length);
}
