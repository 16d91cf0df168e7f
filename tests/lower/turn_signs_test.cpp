#include "lower/network/turn_signs.hpp"

#include <catch2/catch.hpp>

#include "lower/expression_leaves.hpp"

using namespace elgen;

namespace {

std::vector<std::string> turned_texts(const testing::ExpressionLeaves& l) {
  Network network = make_network(l.expressions);
  turn_signs(network);
  CHECK(check_invariants(testing::program_of(network)) == "");
  return testing::texts_of(network);
}

}  // namespace

TEST_CASE("a difference that is only needed negative is turned") {
  testing::ExpressionLeaves l;
  const Ref difference = l.graph.sum({l.a, -l.b});
  l.expressions.values = {-difference, -difference};
  CHECK(turned_texts(l) == std::vector<std::string>{"b - a", "b - a"});
}

TEST_CASE("a product is turned by a difference among its factors") {
  testing::ExpressionLeaves l;
  const Ref difference = l.graph.sum({l.a, -l.b});
  l.expressions.values = {-l.product({l.c, difference}),
                          -l.graph.product({{l.d}, {l.graph.sum({l.c, -l.e}), -1}})};
  CHECK(turned_texts(l) == std::vector<std::string>{"c*(b - a)", "d/(e - c)"});
}

TEST_CASE("arguments are turned, terms of a sum need not be") {
  testing::ExpressionLeaves l;
  l.expressions.values = {l.graph.call(FunctionId::exp, {l.graph.sum({l.b, -l.a})}),
                          l.graph.sum({l.a, -l.product({l.b, l.graph.sum({l.c, -l.d})})})};
  CHECK(turned_texts(l) == std::vector<std::string>{"exp(b - a)", "a - b*(c - d)"});
}

TEST_CASE("nothing is turned that something else needs positive, or that has no difference") {
  testing::ExpressionLeaves l;
  const Ref difference = l.graph.sum({l.a, -l.b});
  l.expressions.values = {-difference, difference, -l.product({l.c, difference}),
                          -l.graph.sum({l.a, l.d}), -l.graph.call(FunctionId::sin, {l.a})};
  CHECK(turned_texts(l) ==
        std::vector<std::string>{"-(a - b)", "a - b", "-c*(a - b)", "-(a + d)", "-sin(a)"});
}
