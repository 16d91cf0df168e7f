#include "lower/graph/flatten.hpp"

#include <catch2/catch.hpp>

#include "lower/expression_leaves.hpp"

using namespace elgen;
using testing::texts_of;

TEST_CASE("what is used once is written out where it is used") {
  testing::ExpressionLeaves l;
  const Ref p = l.graph.sum({l.b, l.d});
  const Ref s = l.graph.sum({p, -l.c});
  const Ref t = l.product({l.b, l.e});
  const Ref w = l.product({t, l.c});
  l.expressions.values = {s, w};
  const Expressions flat = flatten(l.expressions);
  CHECK(texts_of(flat) == std::vector<std::string>{"b - c + d", "b*c*e"});
}

TEST_CASE("signs go with the terms, and terms that meet merge") {
  testing::ExpressionLeaves l;
  const Ref p = l.graph.sum({l.a, -l.b});
  l.expressions.values = {l.graph.sum({l.c, -p}), l.graph.sum({l.a, l.graph.sum({l.a, l.d})})};
  CHECK(texts_of(flatten(l.expressions)) == std::vector<std::string>{"-(a - b - c)", "d + 2*a"});
}

TEST_CASE("what is used twice stays") {
  testing::ExpressionLeaves l;
  const Ref p = l.graph.sum({l.a, l.b});
  l.expressions.values = {l.graph.sum({p, l.c}), l.graph.sum({p, l.d})};
  const Expressions flat = flatten(l.expressions);
  CHECK(testing::counts_of(make_network(flat)).add == 3);
}

TEST_CASE("powers of a product are not written out") {
  testing::ExpressionLeaves l;
  const Ref p = l.product({l.a, l.b});
  l.expressions.values = {l.graph.product({{p, 2}, {l.c}})};
  CHECK(testing::counts_of(make_network(flatten(l.expressions))).mul == 3);
}

TEST_CASE("all products: written out wherever they stand, so that factors meet") {
  testing::ExpressionLeaves l;
  const Ref sine = l.graph.call(FunctionId::sin, {l.b});
  const Ref cosine = l.graph.call(FunctionId::cos, {l.b});
  const Ref p = l.product({l.a, sine});
  const Ref r = l.product({l.a, cosine});
  l.expressions.values = {l.graph.sum({l.product({p, sine}), l.product({r, cosine})}),
                          l.graph.product({{p, -2}, {l.c}}), p, r};
  const Expressions flat = flatten(l.expressions, Flattened::all_products);
  CHECK(texts_of(flat) ==
        std::vector<std::string>{"a", "c/(a^2*sin(b)^2)", "a*sin(b)", "a*cos(b)"});
}
