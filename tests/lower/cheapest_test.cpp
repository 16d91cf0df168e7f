#include "lower/network/cheapest.hpp"

#include <catch2/catch.hpp>

#include "lower/expression_leaves.hpp"

using namespace elgen;

namespace {

std::size_t cheapest_cost(const Expressions& expressions) {
  Function unfilled;
  Field field;
  for (std::uint32_t i = 0; i < expressions.values.size(); ++i) field.entries.push_back(i);
  unfilled.fields = {field};
  return cost(testing::counts_of(cheapest_network(expressions, unfilled)));
}

}  // namespace

TEST_CASE("common factors are collected where that is cheaper") {
  testing::ExpressionLeaves l;
  l.expressions.values = {l.graph.sum({l.product({l.a, l.b, l.c}), l.product({l.a, l.b, l.d})})};
  CHECK(cheapest_cost(l.expressions) == 3);  // a*b*(c + d)
}

TEST_CASE("an angle sum is taken apart where its parts are there, else called") {
  testing::ExpressionLeaves l;
  const Ref sum = l.graph.sum({l.a, l.b});
  const auto cosine = [&](Ref x) { return l.graph.call(FunctionId::cos, {x}); };
  l.expressions.values = {cosine(sum)};
  CHECK(cheapest_cost(l.expressions) == 1 + 26);
  l.expressions.values = {cosine(sum), cosine(l.a), cosine(l.b)};
  CHECK(cheapest_cost(l.expressions) == 3 + 2 * 26);
}
