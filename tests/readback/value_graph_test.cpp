// Expressions are one value where they compute the same numbers by the same operations.
#include "readback/value_graph.hpp"

#include <catch2/catch.hpp>

namespace elgen {
namespace {

const LeafNames names{{{"a"}, {"x", "y", "z"}, {"x", "y", "z"}, {"x", "y", "z"}, {"u"}, "t"}, true};

}  // namespace

TEST_CASE("a minus moves through products and quotients, not through sums") {
  ValueGraph graph;
  const SignedNode x = graph.leaf(Opcode::coordinate, 0);
  const SignedNode y = graph.leaf(Opcode::coordinate, 1);
  const SignedNode product = graph.binary(Opcode::multiply, x, y);
  CHECK(graph.binary(Opcode::multiply, negated(x), y) == negated(product));
  CHECK(graph.binary(Opcode::multiply, x, negated(y)) == negated(product));
  CHECK(graph.binary(Opcode::multiply, negated(x), negated(y)) == product);
  const SignedNode quotient = graph.binary(Opcode::divide, x, y);
  CHECK(graph.binary(Opcode::divide, negated(x), y) == negated(quotient));
  const SignedNode sum = graph.binary(Opcode::add, x, y);
  CHECK_FALSE(graph.binary(Opcode::add, negated(x), negated(y)) == negated(sum));
  CHECK_FALSE(graph.call(FunctionId::sin, negated(x), {}) ==
              negated(graph.call(FunctionId::sin, x, {})));
}

TEST_CASE("the order of operands and of operations counts") {
  ValueGraph graph;
  const SignedNode x = graph.leaf(Opcode::coordinate, 0);
  const SignedNode y = graph.leaf(Opcode::coordinate, 1);
  const SignedNode z = graph.leaf(Opcode::coordinate, 2);
  const auto sum = [&](SignedNode a, SignedNode b) { return graph.binary(Opcode::add, a, b); };
  CHECK_FALSE(sum(x, y) == sum(y, x));
  CHECK_FALSE(sum(sum(x, y), z) == sum(x, sum(y, z)));
  CHECK(sum(x, y) == sum(x, y));
  CHECK_FALSE(graph.leaf(Opcode::velocity, 0) == x);
}

TEST_CASE("a constant is known by its exact value") {
  ValueGraph graph;
  CHECK(graph.constant(cln::cl_RA(1) / 3) == negated(graph.constant(cln::cl_RA(-1) / 3)));
  CHECK_FALSE(graph.constant(cln::cl_RA(1) / 3) == graph.constant(cln::cl_RA(1) / 5));
}

TEST_CASE("a difference is shown where it is") {
  ValueGraph graph;
  const SignedNode x = graph.leaf(Opcode::coordinate, 0);
  const SignedNode y = graph.leaf(Opcode::coordinate, 1);
  const SignedNode z = graph.leaf(Opcode::coordinate, 2);
  const SignedNode a = graph.binary(Opcode::add, graph.call(FunctionId::sin, x, {}), z);
  const SignedNode b = graph.binary(Opcode::add, graph.call(FunctionId::sin, y, {}), z);
  const auto [written, derived] = graph.difference(a, b);
  CHECK(graph.text(names, written) == "q[0]");
  CHECK(graph.text(names, derived) == "q[1]");
  CHECK(graph.text(names, a) == "sin(q[0]) + q[2]");
  graph.set_name(graph.call(FunctionId::sin, x, {}), "sin_x");
  CHECK(graph.text(names, a) == "sin_x + q[2]");
  CHECK(graph.text(names, negated(a)) == "-(sin_x + q[2])");
}

}  // namespace elgen
