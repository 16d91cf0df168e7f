#include "lower/network/linearise.hpp"

#include <catch2/catch.hpp>

#include "lower/expression_leaves.hpp"

using namespace elgen;

TEST_CASE("operands come before use, terms and factors left to right") {
  testing::ExpressionLeaves l;
  l.expressions.values = {l.graph.sum({l.a, -l.b, l.product({l.c, l.d})})};
  CHECK(dump(testing::program_of(make_network(l.expressions))) ==
        "coordinates a b c d e\n"
        "function bias\n"
        "  0 = coordinate a\n"
        "  1 = coordinate b\n"
        "  2 = coordinate c\n"
        "  3 = coordinate d\n"
        "  4 = multiply 2 3\n"
        "  5 = subtract 0 1\n"
        "  6 = add 5 4\n"
        "  result 1 1 = 6\n");
}

TEST_CASE("signs become subtractions, and negations where nothing is there to subtract from") {
  testing::ExpressionLeaves l;
  l.expressions.values = {-l.product({l.a, l.b}), l.graph.call(FunctionId::exp, {-l.a}),
                          l.graph.square_root(-l.b)};
  CHECK(dump(testing::program_of(make_network(l.expressions))) ==
        "coordinates a b c d e\n"
        "function bias\n"
        "  0 = coordinate a\n"
        "  1 = coordinate b\n"
        "  2 = multiply 0 1\n"
        "  3 = negate 2\n"
        "  4 = negate 0\n"
        "  5 = exp 4\n"
        "  6 = negate 1\n"
        "  7 = square_root 6\n"
        "  result 1 3 = 3 5 7\n");
}

TEST_CASE("a sum that starts negative starts from its first positive term, if it has one") {
  Network network;
  network.operations = {{.kind = OperationKind::leaf, .leaf = Opcode::coordinate, .index = 0},
                        {.kind = OperationKind::leaf, .leaf = Opcode::coordinate, .index = 1},
                        {.kind = OperationKind::sum, .operands = {{0, true}, {1, false}}},
                        {.kind = OperationKind::sum, .operands = {{0, true}, {1, true}}}};
  network.values = {{2}, {3}};
  CHECK(testing::texts_of(network) == std::vector<std::string>{"b - a", "-a - b"});
}

TEST_CASE("operations that turn out equal are computed once, and names are kept") {
  Network network;
  network.operations = {{.kind = OperationKind::leaf, .leaf = Opcode::coordinate, .index = 0},
                        {.kind = OperationKind::product, .operands = {{0}, {0}}},
                        {.kind = OperationKind::product, .operands = {{0}, {0}}, .name = "area"}};
  network.values = {{1}, {2, true}};
  const Program program = testing::program_of(network);
  CHECK(check_invariants(program) == "");
  CHECK(program.functions[0].instructions.size() == 3);
  CHECK(program.functions[0].names == std::vector<std::string>{"", "area", ""});
}

TEST_CASE("constants of a program are one list without repeats") {
  testing::ExpressionLeaves l;
  l.expressions.values = {l.graph.product({{l.graph.rational(3)}, {l.a}}),
                          l.graph.sum({l.graph.rational(3), l.b})};
  CHECK(testing::program_of(make_network(l.expressions)).constants.size() == 1);
}
