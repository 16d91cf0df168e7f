#include "lower/angle_sums.hpp"

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
  REQUIRE(has_angle_sums(l.expressions));
  CHECK(texts_of(expand_angle_sums(l.expressions)) ==
        std::vector<std::string>{"-(sin(a)*sin(b) - cos(a)*cos(b))",
                                 "sin(a)*cos(b) + sin(b)*cos(a)", "cos(a)", "sin(b)"});
}

TEST_CASE("differences and multiples are sums too") {
  testing::ExpressionLeaves l;
  const Ref difference = l.graph.sum({l.a, -l.b});
  const Ref twice = l.graph.product({{l.graph.rational(2)}, {l.a}});
  l.expressions.values = {sine(l, difference), cosine(l, twice), sine(l, l.a), sine(l, l.b)};
  CHECK(texts_of(expand_angle_sums(l.expressions)) ==
        std::vector<std::string>{"sin(a)*cos(b) - sin(b)*cos(a)", "-(sin(a)^2 - cos(a)^2)",
                                 "sin(a)", "sin(b)"});
}

TEST_CASE("an angle whose parts do not occur stays") {
  testing::ExpressionLeaves l;
  const Ref sum = l.graph.sum({l.a, l.b});
  l.expressions.values = {cosine(l, sum), sine(l, l.a)};
  CHECK_FALSE(has_angle_sums(l.expressions));
  CHECK(texts_of(expand_angle_sums(l.expressions)) ==
        std::vector<std::string>{"cos(a + b)", "sin(a)"});
}
