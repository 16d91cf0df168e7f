#include "lower/graph/factor.hpp"

#include <catch2/catch.hpp>

#include "lower/expression_leaves.hpp"

using namespace elgen;
using testing::texts_of;

TEST_CASE("common factors are multiplied once") {
  testing::ExpressionLeaves l;
  const Ref sum = l.graph.sum({l.product({l.a, l.b, l.c}), l.product({l.a, l.c, l.d}), -l.e});
  const Ref powers = l.graph.sum({l.graph.product({{l.a, 2}, {l.b}}), l.product({l.a, l.c})});
  l.expressions.values = {sum, powers};
  const Expressions factored = factor(l.expressions);
  CHECK(texts_of(factored) == std::vector<std::string>{"-(e - a*c*(b + d))", "a*(c + a*b)"});
}

TEST_CASE("what is left is factored again, inside and outside") {
  testing::ExpressionLeaves l;
  l.expressions.values = {
      l.graph.sum({l.product({l.a, l.b, l.c}), l.product({l.a, l.b, l.d}), l.product({l.a, l.e}),
                   l.product({l.c, l.d}), l.product({l.c, l.e})})};
  const OperationCounts counts = testing::counts_of(make_network(factor(l.expressions)));
  // a*(e + b*(c + d)) + c*(d + e)
  CHECK(counts == OperationCounts{.add = 4, .mul = 3});
}

TEST_CASE("a product that something else needs too is left alone") {
  testing::ExpressionLeaves l;
  const Ref shared = l.product({l.a, l.b});
  l.expressions.values = {l.graph.sum({shared, l.product({l.a, l.c})}), l.graph.sum({shared, l.d})};
  CHECK(texts_of(factor(l.expressions)) == std::vector<std::string>{"a*b + a*c", "d + a*b"});
}

TEST_CASE("a term that is the factor leaves 1") {
  testing::ExpressionLeaves l;
  l.expressions.values = {l.graph.sum({l.a, -l.product({l.a, l.b})})};
  CHECK(texts_of(factor(l.expressions)) == std::vector<std::string>{"a*(1 - b)"});
}

TEST_CASE("a common factor that is left alone meets itself") {
  testing::ExpressionLeaves l;
  const Ref sine = l.graph.call(FunctionId::sin, {l.b});
  const Ref cosine = l.graph.call(FunctionId::cos, {l.b});
  // What is left of a^2 sin^2 + a^2 cos^2 is 1, then a, then a^2.
  const Ref first = l.graph.product({{l.a, 2}, {sine, 2}, {l.c}});
  const Ref second = l.graph.product({{l.a, 2}, {cosine, 2}, {l.c}});
  l.expressions.values = {l.graph.sum({first, second, l.product({l.c, l.d})})};
  CHECK(texts_of(factor(l.expressions)) == std::vector<std::string>{"c*(d + a^2)"});
  const Ref both = l.graph.product({{l.a, 2}, {l.b, 2}});
  l.expressions.values = {l.graph.sum({both, l.graph.product({{l.a, 2}, {l.d}})})};
  CHECK(texts_of(factor(l.expressions)) == std::vector<std::string>{"a^2*(d + b^2)"});
}

TEST_CASE("a coefficient does not hide common factors") {
  testing::ExpressionLeaves l;
  const Ref twice = l.graph.product({{l.graph.rational(2)}, {l.a}, {l.b}, {l.c}});
  l.expressions.values = {l.graph.sum({twice, l.product({l.a, l.b, l.d})})};
  CHECK(texts_of(factor(l.expressions)) == std::vector<std::string>{"a*b*(d + 2*c)"});
}

TEST_CASE("a coefficient that the scaled product has too is one base with its power") {
  testing::ExpressionLeaves l;
  const Ref root = l.graph.square_root(l.graph.rational(2));
  const Ref inner = l.product({root, l.a, l.b});
  l.expressions.values = {l.graph.sum({l.product({root, inner}), l.product({root, l.c})})};
  CHECK(texts_of(factor(l.expressions)) == std::vector<std::string>{"sqrt(2)*(c + sqrt(2)*a*b)"});
}

TEST_CASE("a common factor keeps its power") {
  testing::ExpressionLeaves l;
  const Ref first = l.graph.product({{l.a}, {l.b, 2}, {l.c, 2}});
  const Ref second = l.graph.product({{l.a}, {l.b, 2}, {l.d, 2}});
  l.expressions.values = {l.graph.sum({first, second})};
  CHECK(texts_of(factor(l.expressions)) == std::vector<std::string>{"a*b^2*(c^2 + d^2)"});
}
