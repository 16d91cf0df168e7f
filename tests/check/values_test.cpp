// ValueReader reads values as roots, constants and references. NodeBuilder builds nodes, and folds
// zeros, ones and rational constants.
#include "check/expressions/values.hpp"

#include <catch2/catch.hpp>

#include "check/expressions/node_builder.hpp"

namespace elgen::test {

namespace {

ValueSyntax value_syntax(const std::string& text) {
  static std::vector<SourcePointer> alive;
  alive.push_back(make_source("m.toml", text));
  auto expression = parse_expression(alive.back(), {});
  REQUIRE(expression);
  ValueSyntax value;
  value.kind = ValueKind::expression;
  value.text = text;
  value.expression = *expression;
  value.span = expression->span;
  return value;
}

ValueSyntax vector_of(std::size_t count) {
  ValueSyntax vector;
  vector.kind = ValueKind::list;
  vector.items.assign(count, value_syntax("x"));
  return vector;
}

/// A model with the coordinate x, and a builder of nodes of this model.
struct Fixture {
  Fixture() {
    Coordinate coordinate;
    coordinate.name = coordinate.identifier = "x";
    append_coordinate(context.model, coordinate);
    x = nodes.leaf(Opcode::coordinate, 0);
    one = nodes.number(1);
    pi = static_cast<ExpressionId>(context.model.expressions.size());
    context.model.expressions.push_back({.kind = ExpressionKind::pi});
    (void)context.constants.evaluate_next(context.model.expressions);
  }

  [[nodiscard]] std::string text(ExpressionId id) const { return to_string(context.model, id); }

  Limits limits = {};
  Context context{limits};
  NodeBuilder nodes{context, {}};
  ExpressionId x = 0;
  ExpressionId one = 0;
  ExpressionId pi = 0;
};

}  // namespace

TEST_CASE("a root covers its nodes, and a failed root leaves no nodes") {
  const Limits limits;
  Context context(limits);
  ValueReader values(context, IndexScope(context.sizes));
  const ExpressionId id = values.root(value_syntax("t*sin(t)"), {});
  REQUIRE(context.roots.size() == 1);
  CHECK(context.roots[0].first == 1);
  CHECK(context.roots[0].value == id);
  CHECK(values.root(value_syntax("t*u"), {}) == no_expression);
  CHECK(context.roots.size() == 1);
  CHECK(context.report.error_count() == 1);
}

TEST_CASE("constants leave no nodes in the arena") {
  const Limits limits;
  Context context(limits);
  ValueReader values(context, IndexScope(context.sizes));
  CHECK(values.read_constant(value_syntax("1/3 + 1")) == cln::cl_RA(4) / 3);
  CHECK(values.read_constant(value_syntax("exp(1)")));
  CHECK_FALSE(values.read_constant(value_syntax("2*t")));
  CHECK(context.model.expressions.size() == 1);
}

TEST_CASE("references find the element of the right kind") {
  const Limits limits;
  Context context(limits);
  context.symbols.declare({"q", 1, {}}, SymbolKind::coordinate, 4, context.report);
  ValueReader values(context, IndexScope(context.sizes));
  CHECK(values.resolve_reference(value_syntax("q[3-2]"), SymbolKind::coordinate) == 4);
  CHECK_FALSE(values.resolve_reference(value_syntax("q[1]"), SymbolKind::point));
  CHECK_FALSE(values.resolve_reference(value_syntax("q[2]"), SymbolKind::coordinate));
  CHECK(context.report.error_count() == 2);
}

TEST_CASE("all vectors of a model have the size of the first") {
  const Limits limits;
  Context context(limits);
  ValueReader values(context, IndexScope(context.sizes));
  CHECK_FALSE(values.check_vector(vector_of(4)));
  CHECK(context.report.error_count() == 1);
  CHECK(values.check_vector(vector_of(3)));
  CHECK(values.check_vector(vector_of(3)));
  CHECK(context.report.error_count() == 1);
  CHECK(values.check_vector(vector_of(2)));
  CHECK(context.report.error_count() == 2);
}

TEST_CASE("keys of tables are found by name") {
  ValueSyntax table;
  table.entries.push_back({"doc", {}, value_syntax("x")});
  CHECK(table.find("doc") != nullptr);
  CHECK(table.find("unit") == nullptr);
  CHECK(text_value(table, "doc") == "x");
  CHECK(text_value(table, "unit").empty());
  EntrySyntax entry;
  entry.keys = table.entries;
  CHECK(text_value(entry, "doc") == "x");
}

TEST_CASE("zeros and ones are folded", "[frames]") {
  Fixture s;
  NodeBuilder& nodes = s.nodes;
  CHECK(nodes.number(0) == no_expression);
  CHECK(nodes.is_one(s.one));
  CHECK(nodes.add({no_expression, s.x, no_expression}) == s.x);
  CHECK(nodes.add({no_expression, no_expression}) == no_expression);
  CHECK(nodes.multiply({s.x, no_expression}) == no_expression);
  CHECK(nodes.multiply({s.one, s.x, s.one}) == s.x);
  CHECK(nodes.divide(no_expression, s.x) == no_expression);
  CHECK(nodes.divide(s.x, s.one) == s.x);
  CHECK(nodes.negate(no_expression) == no_expression);
  const ExpressionId minus_x = nodes.negate(s.x);
  CHECK(nodes.negate(minus_x) == s.x);
  CHECK(nodes.subtract(s.x, no_expression) == s.x);
}

TEST_CASE("signs are moved out of products", "[frames]") {
  Fixture s;
  const ExpressionId minus_one = s.nodes.number(-1);
  CHECK(s.text(s.nodes.multiply({minus_one, s.x})) == "-x");
  CHECK(s.nodes.multiply({minus_one, s.x, minus_one}) == s.x);
  CHECK(s.text(s.nodes.multiply({minus_one, minus_one, minus_one})) == "-1");
}

TEST_CASE("rational constants are folded, others stay as written", "[frames]") {
  Fixture s;
  const ExpressionId three = s.nodes.number(3);
  const ExpressionId half = s.nodes.number(cln::cl_RA(1) / 2);
  CHECK(s.text(s.nodes.add({three, half})) == "7/2");
  CHECK(s.text(s.nodes.divide(three, half)) == "6");
  const ExpressionId four = s.nodes.number(4);
  CHECK(s.text(s.nodes.power(four, cln::cl_RA(-1) / 2)) == "1/2");
  CHECK(s.text(s.nodes.power(three, cln::cl_RA(1) / 2)) == "sqrt(3)");
}

TEST_CASE("sines and cosines of quarter turns are exact", "[frames]") {
  Fixture s;
  for (int k = -4; k <= 4; ++k) {
    const ExpressionId quarters = s.nodes.number(cln::cl_RA(k) / 2);
    const ExpressionId angle = s.nodes.multiply({quarters, s.pi});
    const int expected_sine = k % 2 == 0 ? 0 : (k == 1 || k == -3 ? 1 : -1);
    const int expected_cosine = k % 2 != 0 ? 0 : (k % 4 == 0 ? 1 : -1);
    INFO(k);
    CHECK(s.text(s.nodes.call(FunctionId::sin, angle)) == std::to_string(expected_sine));
    CHECK(s.text(s.nodes.call(FunctionId::cos, angle)) == std::to_string(expected_cosine));
  }
  const ExpressionId third = s.nodes.number(3);
  CHECK(s.text(s.nodes.call(FunctionId::cos, third)) == "cos(3)");
}

TEST_CASE("constants have no rate", "[frames]") {
  Fixture s;
  CHECK(s.nodes.rate(s.pi) == no_expression);
  CHECK(s.text(s.nodes.rate(s.x)) == "dot(x)");
}

TEST_CASE("vectors and matrices", "[frames]") {
  Fixture s;
  NodeBuilder& nodes = s.nodes;
  const Matrix3 quarter{no_expression, nodes.number(-1), no_expression,  // x -> y -> -x
                        s.one,         no_expression,    no_expression,
                        no_expression, no_expression,    s.one};
  const Vector3 along{s.x, no_expression, s.one};
  const Vector3 forth = nodes.apply(quarter, along);
  CHECK(forth[0] == no_expression);
  CHECK(forth[1] == s.x);
  CHECK(nodes.is_one(forth[2]));
  const Vector3 back = nodes.apply_transposed(quarter, along);
  CHECK(back[0] == no_expression);
  CHECK(s.text(back[1]) == "-x");
  const Matrix3 half = nodes.multiply(quarter, quarter);
  CHECK(s.text(half[0]) == "-1");
  CHECK(s.text(half[1]) == "0");
  CHECK(s.text(half[4]) == "-1");
  const Matrix3 identity = nodes.identity();
  CHECK(nodes.is_one(nodes.multiply(identity, identity)[8]));
  const Vector3 sum = nodes.add(along, along);
  CHECK(s.text(sum[0]) == "x + x");
  CHECK(s.text(nodes.dot(along, along)) == "x*x + 1");
}

}  // namespace elgen::test
