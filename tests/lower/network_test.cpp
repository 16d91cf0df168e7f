#include "lower/network/network.hpp"

#include <catch2/catch.hpp>

#include "lower/expression_leaves.hpp"

using namespace elgen;
using testing::counts_of;
using testing::texts_of;

TEST_CASE("powers are repeated factors, denominators one division") {
  testing::ExpressionLeaves l;
  l.expressions.values = {l.graph.product({{l.a, 2}, {l.b}, {l.c, -1}, {l.d, -2}})};
  const Network network = make_network(l.expressions);
  CHECK(texts_of(network) == std::vector<std::string>{"a^2*b/(c*d^2)"});
  CHECK(counts_of(network) == OperationCounts{.mul = 4, .div = 1});
}

TEST_CASE("the constants of a sum or product are folded into one number") {
  testing::ExpressionLeaves l;
  const Ref pi = l.graph.pi();
  const Ref two = l.graph.rational(2);
  const Ref cosine = l.graph.call(FunctionId::cos, {l.graph.rational(1)});
  l.expressions.values = {
      l.product({two, pi, cosine, l.a}), l.graph.sum({two, -pi, l.a}),
      -l.graph.sum({l.graph.rational(1), -l.graph.call(FunctionId::exp, {two})})};
  const Network network = make_network(l.expressions);
  CHECK(counts_of(network) == OperationCounts{.add = 1, .mul = 1});
  CHECK(texts_of(network) ==
        std::vector<std::string>{"2*pi*cos(1)*a", "a - (-2 + pi)", "-1 + exp(2)"});
}

TEST_CASE("a constant has one form, whatever its parts were shared with") {
  testing::ExpressionLeaves l;
  const Ref four = l.graph.sum({l.graph.rational(4), l.graph.pi()});
  const Ref forty = l.graph.sum({l.graph.rational(40), -l.graph.call(FunctionId::cos, {four})});
  l.expressions.values = {l.graph.sum({four, forty, l.a}), l.product({four, l.b}),
                          l.product({forty, l.c}), l.graph.sum({l.graph.pi(), forty, four, l.d})};
  const std::vector<std::string> texts = texts_of(make_network(l.expressions));
  CHECK(texts[0] == "44 + pi - cos(4 + pi) + a");
  CHECK(texts[3] == "44 + 2*pi - cos(4 + pi) + d");
}

TEST_CASE("a constant without a value stays an operation") {
  testing::ExpressionLeaves l;
  const Ref log = l.graph.call(FunctionId::log, {l.graph.rational(-1)});
  l.expressions.values = {l.product({l.graph.rational(2), log, l.a})};
  CHECK(texts_of(make_network(l.expressions)) == std::vector<std::string>{"2*log(-1)*a"});
}

TEST_CASE("high powers are squared repeatedly") {
  testing::ExpressionLeaves l;
  l.expressions.values = {l.graph.product({{l.a, 13}})};
  const Network network = make_network(l.expressions);
  CHECK(counts_of(network).mul == 5);  // a * ((a^2)^2)^3
  CHECK(texts_of(network) == std::vector<std::string>{"a^13"});
}

TEST_CASE("what divides two products becomes a reciprocal") {
  testing::ExpressionLeaves l;
  l.expressions.values = {l.graph.product({{l.a}, {l.c, -1}}), l.graph.product({{l.b}, {l.c, -1}})};
  CHECK(counts_of(make_network(l.expressions)) == OperationCounts{.mul = 2, .div = 1});
}

TEST_CASE("operations follow their operands in canonical order") {
  testing::ExpressionLeaves l;
  l.expressions.values = {l.graph.sum({l.e, l.product({l.d, l.c}), l.a})};
  const Network network = make_network(l.expressions);
  std::vector<std::uint32_t> leaves;
  for (NodeId id = 0; id < network.operations.size(); ++id) {
    const Operation& operation = network.operations[id];
    if (operation.kind == OperationKind::leaf) leaves.push_back(operation.index);
    for (const Ref operand : operation.operands) CHECK(operand.node < id);
  }
  CHECK(leaves == std::vector<std::uint32_t>{0, 4, 2, 3});
}
