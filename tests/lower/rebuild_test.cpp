#include "lower/graph/rebuild.hpp"

#include <catch2/catch.hpp>

#include "lower/expression_leaves.hpp"

using namespace elgen;

TEST_CASE("an unchanging rule copies values, names and births, and leaves out what is unused") {
  testing::ExpressionLeaves l;
  l.graph.set_birth(3);
  const Ref root = l.graph.square_root(l.graph.sum({l.a, -l.b}));
  l.graph.name(root, "distance");
  const Ref pi = l.graph.pi();
  const Ref call = l.graph.call(FunctionId::atan2, {-l.c, root});
  l.expressions.values = {-l.graph.product({{call, 2}, {pi}, {l.d, -1}})};
  const Expressions copied = rebuild(l.expressions, copy);
  CHECK(testing::texts_of(copied) == testing::texts_of(l.expressions));
  CHECK(copied.graph.size() < l.graph.size());  // e is used by nothing
  std::size_t named = 0;
  for (NodeId id = 0; id < copied.graph.size(); ++id) {
    const Node& node = copied.graph.node(id);
    if (node.name != "distance") continue;
    ++named;
    CHECK(node.birth == 3);
  }
  CHECK(named == 1);
}

TEST_CASE("a rule may turn signs: users see the renewed operand") {
  testing::ExpressionLeaves l;
  l.expressions.values = {l.graph.sum({l.a, l.b}), l.product({l.a, l.b})};
  const Expressions turned = rebuild(l.expressions, [](Graph& graph, const RebuildStep& step) {
    const Ref same = copy(graph, step);
    return same == graph.leaf(Opcode::coordinate, 1) ? -same : same;
  });
  CHECK(testing::texts_of(turned) == std::vector<std::string>{"a - b", "-a*b"});
}

TEST_CASE("a copy in another graph meets what is there") {
  testing::ExpressionLeaves l;
  l.expressions.values = {-l.graph.sum({l.a, l.b})};
  Expressions other;
  const Ref first = copied(other.graph, l.expressions);
  const std::size_t size = other.graph.size();
  CHECK(copied(other.graph, l.expressions) == first);
  CHECK(other.graph.size() == size);
  other.values = {first};
  CHECK(testing::texts_of(other) == testing::texts_of(l.expressions));
}
