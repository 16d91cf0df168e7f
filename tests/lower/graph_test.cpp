#include "lower/graph/graph.hpp"

#include <catch2/catch.hpp>

using namespace elgen;

TEST_CASE("equal nodes are one node") {
  Graph graph;
  const Ref x = graph.leaf(Opcode::coordinate, 0);
  const Ref y = graph.leaf(Opcode::coordinate, 1);
  CHECK(graph.leaf(Opcode::coordinate, 0) == x);
  CHECK(graph.leaf(Opcode::velocity, 0).node != x.node);
  CHECK(graph.sum({x, y}) == graph.sum({y, x}));
  CHECK(graph.rational(-2) == -graph.rational(2));
}

TEST_CASE("odd functions give up the sign of their argument, even ones drop it") {
  Graph graph;
  const Ref x = graph.leaf(Opcode::coordinate, 0);
  for (const FunctionId odd : {FunctionId::sin, FunctionId::tan, FunctionId::asin, FunctionId::atan,
                               FunctionId::sinh, FunctionId::tanh, FunctionId::sign}) {
    CHECK(graph.call(odd, {-x}) == -graph.call(odd, {x}));
  }
  for (const FunctionId even : {FunctionId::cos, FunctionId::cosh, FunctionId::abs}) {
    CHECK(graph.call(even, {-x}) == graph.call(even, {x}));
  }
  for (const FunctionId neither : {FunctionId::exp, FunctionId::log, FunctionId::acos}) {
    CHECK(graph.call(neither, {-x}).node != graph.call(neither, {x}).node);
  }
}

TEST_CASE("min and max commute, atan2 does not") {
  Graph graph;
  const Ref x = graph.leaf(Opcode::coordinate, 0);
  const Ref y = graph.leaf(Opcode::coordinate, 1);
  CHECK(graph.call(FunctionId::min, {y, -x}) == graph.call(FunctionId::min, {-x, y}));
  CHECK(graph.call(FunctionId::atan2, {x, y}).node != graph.call(FunctionId::atan2, {y, x}).node);
}

TEST_CASE("a term meets its opposite in a sum beside it") {
  Graph graph;
  const Ref x = graph.leaf(Opcode::coordinate, 0);
  const Ref y = graph.leaf(Opcode::coordinate, 1);
  const Ref z = graph.leaf(Opcode::coordinate, 2);
  const Ref two = graph.rational(2);
  CHECK(graph.sum({x, graph.sum({y, -x})}) == y);
  CHECK(graph.sum({x, -graph.sum({x, -y})}) == y);
  const Ref doubled = graph.product({{two}, {graph.sum({x, y, z})}});
  CHECK(graph.sum({doubled, -graph.product({{two}, {x}})}) ==
        graph.product({{two}, {graph.sum({y, z})}}));
  CHECK(graph.sum({x, graph.sum({graph.rational(1), -x}), -graph.rational(1)}) ==
        graph.rational(0));
  const Ref unlike = graph.sum({x, graph.sum({x, y})});
  CHECK(graph.node(unlike.node).operands.size() == 2);
}

TEST_CASE("the order: kinds of leaves, then birth, then structure") {
  Graph graph;
  const Ref time = graph.leaf(Opcode::time, 0);
  const Ref velocity = graph.leaf(Opcode::velocity, 0);
  const Ref y = graph.leaf(Opcode::coordinate, 1);
  const Ref x = graph.leaf(Opcode::coordinate, 0);
  graph.set_birth(2);
  const Ref late = graph.call(FunctionId::cos, {x});
  graph.set_birth(1);
  const Ref early = graph.call(FunctionId::sin, {y});
  const Ref early_cosine = graph.call(FunctionId::cos, {y});
  const Ref early_sum = graph.sum({x, y});
  const Ref parameter = graph.leaf(Opcode::parameter, 0);
  const Ref half = graph.rational(cln::cl_RA("1/2"));
  const Ref pi = graph.pi();
  const std::vector<Ref> ordered = {half,         pi,        parameter, x,        y,   early,
                                    early_cosine, early_sum, late,      velocity, time};
  for (std::size_t i = 0; i < ordered.size(); ++i) {
    for (std::size_t j = 0; j < ordered.size(); ++j) {
      CHECK(graph.less(ordered[i].node, ordered[j].node) == (i < j));
    }
  }
}

TEST_CASE("only what outputs need is reachable, and uses are counted by operand") {
  Graph graph;
  const Ref x = graph.leaf(Opcode::coordinate, 0);
  const Ref y = graph.leaf(Opcode::coordinate, 1);
  const Ref sine = graph.call(FunctionId::sin, {x});
  const Ref sum = graph.sum({sine, x});
  const Ref unused = graph.product({{sum}, {y}});
  CHECK(reachable(graph, {sum}) == std::vector<NodeId>{x.node, sine.node, sum.node});
  const std::vector<std::uint32_t> uses = use_counts(graph, {sum, -sine});
  CHECK(uses[x.node] == 2);
  CHECK(uses[sine.node] == 2);
  CHECK(uses[sum.node] == 1);
  CHECK(uses[unused.node] == 0);
}

TEST_CASE("the first name of a node stays, and belongs to its positive value") {
  Graph graph;
  const Ref x = graph.leaf(Opcode::coordinate, 0);
  const Ref sine = graph.call(FunctionId::sin, {x});
  graph.name(x, "alias");
  graph.name(-sine, "negative");
  CHECK(graph.node(sine.node).name.empty());
  graph.name(sine, "height");
  graph.name(sine, "other");
  CHECK(graph.node(sine.node).name == "height");
  CHECK(graph.node(x.node).name.empty());
}

TEST_CASE("calls and roots of constants are constants, and numbers only where they are exact") {
  Graph graph;
  CHECK(graph.call(FunctionId::cos, {graph.rational(0)}) == graph.rational(1));
  CHECK(graph.call(FunctionId::log, {graph.rational(1)}) == graph.rational(0));
  CHECK(graph.square_root(graph.rational(4)) == graph.rational(2));
  const Ref cosine = graph.call(FunctionId::cos, {graph.rational(cln::cl_RA("1/1000000000000"))});
  CHECK(graph.is_constant(cosine.node));
  CHECK_FALSE(graph.is_rational(cosine.node));
  CHECK(graph.is_zero(graph.rational(0).node));
  CHECK_FALSE(graph.is_zero(cosine.node));
  const Ref x = graph.leaf(Opcode::coordinate, 0);
  CHECK_FALSE(graph.is_constant(graph.sum({x, cosine}).node));
}

TEST_CASE("abs, sign, min and max of constants are one of them, or a sign") {
  Graph graph;
  const Ref pi = graph.pi();
  const Ref three = graph.rational(3);
  CHECK(graph.call(FunctionId::max, {three, pi}) == pi);
  CHECK(graph.call(FunctionId::min, {pi, three}) == three);
  CHECK(graph.call(FunctionId::min, {three, -pi}) == -pi);
  CHECK(graph.call(FunctionId::max, {-pi, graph.rational(-4)}) == -pi);
  CHECK(graph.call(FunctionId::abs, {graph.sum({three, -pi})}) == graph.sum({pi, -three}));
  CHECK(graph.call(FunctionId::sign, {-pi}) == graph.rational(-1));
  CHECK(graph.call(FunctionId::sign, {graph.rational(0)}) == graph.rational(0));
  const Ref x = graph.leaf(Opcode::coordinate, 0);
  CHECK(graph.node(graph.call(FunctionId::max, {x, pi}).node).kind == NodeKind::call);
}

TEST_CASE("different constants are different nodes, however close their values are") {
  Graph graph;
  const Ref one = graph.rational(1);
  const Ref cosine = graph.call(FunctionId::cos, {one});
  const Ref less = graph.call(FunctionId::exp, {graph.sum({cosine, -one})});
  const Ref more = graph.call(FunctionId::exp, {-graph.sum({one, cosine})});
  CHECK(less != more);
  CHECK(graph.sum({one, cosine}) != graph.sum({one, -cosine}));
  const Ref root2 = graph.square_root(graph.rational(2));
  CHECK(graph.product({{root2, 2}}) == graph.rational(2));
}

TEST_CASE("a constant product is one node, however it came about") {
  Graph graph;
  const auto number = [&graph](const char* text) { return graph.rational(cln::cl_RA(text)); };
  const Ref logarithm = graph.call(FunctionId::log, {number("2")});
  const Ref square = graph.product({{logarithm, 2}});
  const Ref scaled = graph.product({{number("10/3")}, {logarithm, 2}});
  CHECK(graph.product({{number("10/3")}, {square}}) == scaled);
  CHECK(graph.sum({graph.product({{number("5/6")}, {square}}),
                   graph.product({{number("5/2")}, {square}})}) == scaled);
}

TEST_CASE("a constant of shared parts has no form before its tree is too large") {
  Graph graph;
  Ref x = graph.pi();
  for (int i = 0; i < 60; ++i) {
    x = graph.sum({graph.call(FunctionId::sin, {x}), graph.call(FunctionId::cos, {x})});
  }
  CHECK(graph.is_constant(x.node));
  CHECK_FALSE(graph.has_form(x.node));
}
