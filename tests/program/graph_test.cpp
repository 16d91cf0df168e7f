// Graph: one node for equal values, normal forms, and the order of nodes.
#include "program/graph/graph.hpp"

#include <catch2/catch.hpp>

#include "program/expression_leaves.hpp"

using namespace elgen;
using namespace elgen::test;

namespace {

struct EqualRow {
  const char* text;
  const char* same;
};

/// Checks in one graph for all rows that both texts of a row have the same value.
void check_equal(const std::vector<EqualRow>& rows) {
  Graph graph;
  for (const EqualRow& row : rows) {
    INFO(row.text << " is " << row.same);
    CHECK(value_of(graph, row.text) == value_of(graph, row.same));
  }
}

const Node& node_of(Graph& graph, const char* text) {
  return graph.node(value_of(graph, text).node);
}

}  // namespace

TEST_CASE("stumpff is even only in its first argument") {
  Graph graph;
  CHECK(value_of(graph, "stumpff(-a, -4)") == value_of(graph, "stumpff(a, -4)"));
  CHECK_FALSE(value_of(graph, "stumpff(a, -4)") == value_of(graph, "stumpff(a, 4)"));
  CHECK(texts_of(expressions_of({"stumpff(-a, -4)"})) == Texts{"stumpff(a, -4)"});
}

TEST_CASE("equal nodes are shared") {
  Graph graph;
  const SignedNode x = graph.leaf(Opcode::coordinate, 0);
  const SignedNode y = graph.leaf(Opcode::coordinate, 1);
  CHECK(graph.leaf(Opcode::coordinate, 0) == x);
  CHECK(graph.leaf(Opcode::velocity, 0).node != x.node);
  CHECK(graph.sum({x, y}) == graph.sum({y, x}));
  CHECK(graph.rational(-2) == -graph.rational(2));
}

TEST_CASE("sums merge equal terms with exact coefficients, and factor out a sign") {
  check_equal({{"b - a + 2*a", "a + b"},
               {"1/3*a + 2/3*a", "a"},
               {"a - a", "0"},
               {"1/2 + a - 1/2", "a"},
               {"b - a", "-(a - b)"},
               {"-a - b", "-(a + b)"},
               {"2*b - 2*a", "-(2*(a - b))"}});
  Graph graph;
  CHECK(graph.sum({}) == graph.rational(0));
  CHECK_FALSE(value_of(graph, "a - b").is_negative);
  CHECK(node_of(graph, "2*a + 3*b").kind == NodeKind::sum);
}

TEST_CASE("a term cancels with its opposite in a nested sum") {
  check_equal({{"a + (b - a)", "b"},
               {"a - (a - b)", "b"},
               {"2*(a + b + c) - 2*a", "2*(b + c)"},
               {"a + (1 - a) - 1", "0"}});
  Graph graph;
  CHECK(node_of(graph, "a + (a + b)").operands.size() == 2);
}

TEST_CASE("products merge equal bases up to sign and their coefficients, and 0 gives 0") {
  check_equal({{"(a - b)*(b - a)", "-((a - b)^2)"},
               {"a^3*a^(-2)", "a"},
               {"a^2*a^(-2)", "1"},
               {"(-a)^2", "a^2"},
               {"(2*a)*(1/2*b)", "a*b"},
               {"(2*a)^(-1)", "1/2*a^(-1)"},
               {"(2*(b*c))*(1/2*a)", "(b*c)*a"},
               {"a*0", "0"}});
  Graph graph;
  CHECK(graph.product({}) == graph.rational(1));
  const Node& node = node_of(graph, "2*pi*a*0.25");
  REQUIRE(node.operands.size() == 3);
  CHECK(graph.rational_of(node.operands[0].node) == cln::cl_RA(1) / 2);
  CHECK(graph.node(node.operands[1].node).kind == NodeKind::pi);
}

TEST_CASE("the square of a square root is its radicand") {
  check_equal({{"sqrt(a)^2", "a"},
               {"sqrt(a)^3*a^(-1)", "sqrt(a)"},
               {"sqrt(-a)^2", "-a"},
               {"sqrt(a)^(-2)", "a^(-1)"},
               {"sqrt(2)^2", "2"}});
}

TEST_CASE("the squares of sine and cosine of one angle add up to 1") {
  check_equal({{"sin(a)^2 + cos(a)^2", "1"},
               {"b*sin(a)^2 + c + b*cos(a)^2", "b + c"},
               {"-(b*sin(a)^2) + b - b*cos(a)^2", "0"}});
  Graph graph;
  CHECK(node_of(graph, "b*cos(a)^2 - b*sin(a)^2").kind == NodeKind::sum);
  CHECK(node_of(graph, "sin(a)^2 + cos(b)^2").operands.size() == 2);
}

TEST_CASE("odd functions factor out the sign of their argument, even functions drop it") {
  Graph graph;
  for (const FunctionRow& row : function_table()) {
    if (row.arity != 1) continue;
    INFO(row.name);
    const SignedNode of_negative = value_of(graph, std::string(row.name) + "(-a)");
    const SignedNode value = value_of(graph, std::string(row.name) + "(a)");
    switch (row.parity) {
      case Parity::odd:
        CHECK(of_negative == -value);
        break;
      case Parity::even:
        CHECK(of_negative == value);
        break;
      case Parity::none:
        CHECK(of_negative.node != value.node);
        break;
    }
  }
}

TEST_CASE("min and max commute, atan2 does not") {
  check_equal({{"min(b, -a)", "min(-a, b)"}, {"max(b, a)", "max(a, b)"}});
  Graph graph;
  CHECK(value_of(graph, "atan2(a, b)").node != value_of(graph, "atan2(b, a)").node);
}

TEST_CASE("nodes are ordered by kind of leaf, then birth, then structure") {
  Graph graph;
  const SignedNode time = graph.leaf(Opcode::time, 0);
  const SignedNode velocity = graph.leaf(Opcode::velocity, 0);
  const SignedNode y = graph.leaf(Opcode::coordinate, 1);
  const SignedNode x = graph.leaf(Opcode::coordinate, 0);
  graph.set_creation_rank(2);
  const SignedNode late = graph.call(FunctionId::cos, {x});
  graph.set_creation_rank(1);
  const SignedNode early = graph.call(FunctionId::sin, {y});
  const SignedNode early_cosine = graph.call(FunctionId::cos, {y});
  const SignedNode early_sum = graph.sum({x, y});
  const SignedNode parameter = graph.leaf(Opcode::parameter, 0);
  const SignedNode half = graph.rational(cln::cl_RA("1/2"));
  const SignedNode pi = graph.pi();
  const std::vector<SignedNode> ordered = {half,         pi,        parameter, x,        y,   early,
                                           early_cosine, early_sum, late,      velocity, time};
  for (std::size_t i = 0; i < ordered.size(); ++i) {
    for (std::size_t j = 0; j < ordered.size(); ++j) {
      CHECK(graph.less(ordered[i].node, ordered[j].node) == (i < j));
    }
  }
}

TEST_CASE("only nodes that outputs need are reachable, and uses are counted per operand") {
  Graph graph;
  const SignedNode x = graph.leaf(Opcode::coordinate, 0);
  const SignedNode y = graph.leaf(Opcode::coordinate, 1);
  const SignedNode sine = graph.call(FunctionId::sin, {x});
  const SignedNode sum = graph.sum({sine, x});
  const SignedNode unused = graph.product({{sum}, {y}});
  CHECK(reachable_nodes(graph, {sum}) == std::vector<NodeId>{x.node, sine.node, sum.node});
  const std::vector<std::uint32_t> uses = use_counts(graph, {sum, -sine});
  CHECK(uses[x.node] == 2);
  CHECK(uses[sine.node] == 2);
  CHECK(uses[sum.node] == 1);
  CHECK(uses[unused.node] == 0);
}

TEST_CASE("a node keeps its first name, which belongs to its positive value") {
  Graph graph;
  const SignedNode x = graph.leaf(Opcode::coordinate, 0);
  const SignedNode sine = graph.call(FunctionId::sin, {x});
  graph.set_name(x, "alias");
  graph.set_name(-sine, "negative");
  CHECK(graph.node(sine.node).name.empty());
  graph.set_name(sine, "height");
  graph.set_name(sine, "other");
  CHECK(graph.node(sine.node).name == "height");
  CHECK(graph.node(x.node).name.empty());
}

TEST_CASE("calls and roots of constants are constants, and rationals only if exact") {
  check_equal({{"cos(0)", "1"}, {"log(1)", "0"}, {"sqrt(4)", "2"}});
  Graph graph;
  const SignedNode cosine = value_of(graph, "cos(1/1000000000000)");
  CHECK(graph.is_constant(cosine.node));
  CHECK_FALSE(graph.is_rational(cosine.node));
  CHECK(graph.is_zero(graph.rational(0).node));
  CHECK_FALSE(graph.is_zero(cosine.node));
  CHECK_FALSE(graph.is_constant(graph.sum({graph.leaf(Opcode::coordinate, 0), cosine}).node));
}

TEST_CASE("abs, sign, min and max of constants are evaluated") {
  check_equal({{"max(3, pi)", "pi"},
               {"min(pi, 3)", "3"},
               {"min(3, -pi)", "-pi"},
               {"max(-pi, -4)", "-pi"},
               {"abs(3 - pi)", "pi - 3"},
               {"sign(-pi)", "-1"},
               {"sign(0)", "0"}});
  Graph graph;
  CHECK(node_of(graph, "max(a, pi)").kind == NodeKind::call);
}

TEST_CASE("different constants are different nodes, however close their values are") {
  Graph graph;
  CHECK(value_of(graph, "exp(cos(1) - 1)") != value_of(graph, "exp(-(1 + cos(1)))"));
  CHECK(value_of(graph, "1 + cos(1)") != value_of(graph, "1 - cos(1)"));
}

TEST_CASE("a constant product is one node, however it was built") {
  Graph graph;
  const auto number = [&graph](const char* text) { return graph.rational(cln::cl_RA(text)); };
  const SignedNode logarithm = graph.call(FunctionId::log, {number("2")});
  const SignedNode square = graph.product({{logarithm, 2}});
  const SignedNode scaled = graph.product({{number("10/3")}, {logarithm, 2}});
  CHECK(graph.product({{number("10/3")}, {square}}) == scaled);
  CHECK(graph.sum({graph.product({{number("5/6")}, {square}}),
                   graph.product({{number("5/2")}, {square}})}) == scaled);
}

TEST_CASE("a constant built from shared nodes has no form if its tree is too large") {
  Graph graph;
  SignedNode x = graph.pi();
  for (int i = 0; i < 60; ++i) {
    x = graph.sum({graph.call(FunctionId::sin, {x}), graph.call(FunctionId::cos, {x})});
  }
  CHECK(graph.is_constant(x.node));
  CHECK_FALSE(graph.has_constant_form(x.node));
}
