#include <catch2/catch.hpp>

#include "lower/graph/graph.hpp"

using namespace elgen;

namespace {

struct GraphLeaves {
  Graph graph = {};
  Ref x = graph.leaf(Opcode::coordinate, 0);
  Ref y = graph.leaf(Opcode::coordinate, 1);
  Ref z = graph.leaf(Opcode::coordinate, 2);

  Ref number(const char* text) { return graph.rational(cln::cl_RA(text)); }
  Ref times(const char* factor, Ref value) { return graph.product({{number(factor)}, {value}}); }
};

}  // namespace

TEST_CASE("sums merge equal terms with exact coefficients") {
  GraphLeaves l;
  CHECK(l.graph.sum({l.y, -l.x, l.times("2", l.x)}) == l.graph.sum({l.x, l.y}));
  CHECK(l.graph.sum({l.times("1/3", l.x), l.times("2/3", l.x)}) == l.x);
  CHECK(l.graph.sum({l.x, -l.x}) == l.graph.rational(0));
  CHECK(l.graph.sum({l.number("1/2"), l.x, l.number("-1/2")}) == l.x);
  CHECK(l.graph.sum({}) == l.graph.rational(0));
}

TEST_CASE("the leading term of a sum is positive, its sign outside") {
  GraphLeaves l;
  const Ref difference = l.graph.sum({l.x, -l.y});
  CHECK_FALSE(difference.negative);
  CHECK(l.graph.sum({l.y, -l.x}) == -difference);
  CHECK(l.graph.sum({-l.x, -l.y}) == -l.graph.sum({l.x, l.y}));
}

TEST_CASE("a coefficient that all terms share comes out of the sum") {
  GraphLeaves l;
  const Ref sum = l.graph.sum({l.times("2", l.y), l.times("-2", l.x)});
  CHECK(sum == -l.times("2", l.graph.sum({l.x, -l.y})));
  const Ref mixed = l.graph.sum({l.times("2", l.x), l.times("3", l.y)});
  CHECK(l.graph.node(mixed.node).kind == NodeKind::sum);
}

TEST_CASE("products merge equal bases up to sign") {
  GraphLeaves l;
  const Ref difference = l.graph.sum({l.x, -l.y});
  CHECK(l.graph.product({{difference}, {-difference}}) == -l.graph.product({{difference, 2}}));
  CHECK(l.graph.product({{l.x, 3}, {l.x, -2}}) == l.x);
  CHECK(l.graph.product({{l.x, 2}, {l.x, -2}}) == l.graph.rational(1));
  CHECK(l.graph.product({{-l.x, 2}}) == l.graph.product({{l.x, 2}}));
  CHECK(l.graph.product({}) == l.graph.rational(1));
}

TEST_CASE("coefficients meet, and zero swallows") {
  GraphLeaves l;
  CHECK(l.graph.product({{l.times("2", l.x)}, {l.times("1/2", l.y)}}) ==
        l.graph.product({{l.x}, {l.y}}));
  CHECK(l.graph.product({{l.times("2", l.x), -1}}) ==
        l.graph.product({{l.number("1/2")}, {l.x, -1}}));
  const Ref pair = l.graph.product({{l.y}, {l.z}});
  CHECK(l.graph.product({{l.times("2", pair)}, {l.times("1/2", l.x)}}) ==
        l.graph.product({{pair}, {l.x}}));
  CHECK(l.graph.product({{l.x}, {l.number("0")}}) == l.graph.rational(0));
}

TEST_CASE("rational numbers fold into one factor") {
  GraphLeaves l;
  const Ref pi = l.graph.pi();
  const Ref product = l.graph.product({{l.number("2")}, {pi}, {l.x}, {l.number("1/4")}});
  const Node& node = l.graph.node(product.node);
  REQUIRE(node.operands.size() == 3);
  CHECK(l.graph.rational_of(node.operands[0].node) == cln::cl_RA(1) / 2);
  CHECK(node.operands[1].node == pi.node);
  CHECK(node.operands[2].node == l.x.node);
}

TEST_CASE("the square of a square root is its radicand") {
  GraphLeaves l;
  const Ref root = l.graph.square_root(l.x);
  CHECK(l.graph.product({{root, 2}}) == l.x);
  CHECK(l.graph.product({{root, 3}, {l.x, -1}}) == root);
  CHECK(l.graph.product({{l.graph.square_root(-l.x), 2}}) == -l.x);
  CHECK(l.graph.product({{root, -2}}) == l.graph.product({{l.x, -1}}));
}

TEST_CASE("the squares of sine and cosine of one angle add up") {
  GraphLeaves l;
  const Ref sine = l.graph.call(FunctionId::sin, {l.x});
  const Ref cosine = l.graph.call(FunctionId::cos, {l.x});
  const auto squared = [&](Ref factor, Ref base) { return l.graph.product({{factor}, {base, 2}}); };
  const Ref one = l.number("1");
  CHECK(l.graph.sum({squared(one, sine), squared(one, cosine)}) == one);
  CHECK(l.graph.sum({squared(l.y, sine), l.z, squared(l.y, cosine)}) == l.graph.sum({l.y, l.z}));
  CHECK(l.graph.sum({squared(-l.y, sine), l.y, squared(-l.y, cosine)}) == l.number("0"));
  const Ref difference = l.graph.sum({squared(l.y, cosine), -squared(l.y, sine)});
  CHECK(l.graph.node(difference.node).kind == NodeKind::sum);
  const Ref other = l.graph.call(FunctionId::cos, {l.y});
  const Ref unequal = l.graph.sum({squared(one, sine), squared(one, other)});
  CHECK(l.graph.node(unequal.node).operands.size() == 2);
}
