#include "lower/network/share.hpp"

#include <catch2/catch.hpp>

#include "elgen/evaluate.hpp"
#include "lower/expression_leaves.hpp"

using namespace elgen;

namespace {

OperationCounts counts_after_sharing(const Expressions& expressions) {
  Network network = make_network(expressions);
  share(network);
  CHECK(check_invariants(testing::program_of(network)) == "");
  return testing::counts_of(network);
}

}  // namespace

TEST_CASE("common sub-products are computed once") {
  testing::ExpressionLeaves l;
  l.expressions.values = {l.product({l.a, l.b, l.c}), l.product({l.a, l.b, l.d}),
                          l.product({l.a, l.b, l.e})};
  CHECK(counts_after_sharing(l.expressions).mul == 4);
}

TEST_CASE("common sub-sums count up to sign") {
  testing::ExpressionLeaves l;
  l.expressions.values = {l.graph.sum({l.a, l.b, -l.c}), l.graph.sum({l.b, l.c, -l.d}),
                          l.graph.sum({-l.b, -l.d, l.c, l.e})};
  // b - c in the first and last; the second has b + c and c - d.
  CHECK(counts_after_sharing(l.expressions).add == 6);
}

TEST_CASE("an operation that is the pair serves the others") {
  testing::ExpressionLeaves l;
  l.expressions.values = {l.product({l.a, l.c}), l.product({l.a, l.b, l.c})};
  CHECK(counts_after_sharing(l.expressions).mul == 2);
}

TEST_CASE("squares are shared with products that contain them") {
  testing::ExpressionLeaves l;
  l.expressions.values = {l.graph.product({{l.a, 2}}), l.graph.product({{l.a, 2}, {l.b}}),
                          l.graph.product({{l.a, 4}})};
  CHECK(counts_after_sharing(l.expressions).mul == 3);
}

TEST_CASE("sharing changes no value") {
  testing::ExpressionLeaves l;
  const Ref p = l.product({l.a, l.b});
  l.expressions.values = {l.graph.sum({p, l.c, -l.d}), l.graph.sum({l.d, -p, l.e}),
                          l.graph.sum({l.c, -l.d, p, l.e}), l.product({p, l.c, l.d})};
  Network network = make_network(l.expressions);
  const Program before = testing::program_of(network);
  share(network);
  const Program after = testing::program_of(network);
  Arguments<double> arguments;
  arguments.q = {2, 3, 5, 7, 11};  // integers: every order of evaluation is exact
  CHECK(evaluate(before, before.functions[0], arguments) ==
        evaluate(after, after.functions[0], arguments));
}

TEST_CASE("long sums are shared with their neighbours only, and correctly") {
  Network network;
  std::vector<Ref> terms;
  for (std::uint32_t i = 0; i < 200; ++i) {
    network.operations.push_back(
        {.kind = OperationKind::leaf, .leaf = Opcode::coordinate, .index = i});
    terms.push_back({i});
  }
  network.operations.push_back({.kind = OperationKind::sum, .operands = terms});
  terms.back().negative = true;
  network.operations.push_back({.kind = OperationKind::sum, .operands = terms});
  network.values = {{200}, {201}};
  share(network);
  Program program = testing::program_of(network);
  CHECK(count_operations(program.functions[0]).add == 200);
}
