// Values: roots, constants and references of one entry.
#include "check/expressions/values.hpp"

#include <catch2/catch.hpp>

namespace elgen {
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

TEST_CASE("a root is a run of nodes, a failed one is none") {
  const Limits limits;
  Context context(limits);
  ValueReader values(context, Scope(context.sizes));
  const ExpressionId id = values.root(value_syntax("t*sin(t)"), {});
  REQUIRE(context.roots.size() == 1);
  CHECK(context.roots[0].first == 1);
  CHECK(context.roots[0].value == id);
  CHECK(values.root(value_syntax("t*u"), {}) == no_expression);
  CHECK(context.roots.size() == 1);
  CHECK(context.report.errors() == 1);
}

TEST_CASE("constants leave nothing behind in the arena") {
  const Limits limits;
  Context context(limits);
  ValueReader values(context, Scope(context.sizes));
  CHECK(values.constant(value_syntax("1/3 + 1")) == cln::cl_RA(4) / 3);
  CHECK(values.constant(value_syntax("exp(1)")));
  CHECK_FALSE(values.constant(value_syntax("2*t")));
  CHECK(context.model.expressions.size() == 1);
}

TEST_CASE("references find the element of the right kind") {
  const Limits limits;
  Context context(limits);
  context.symbols.declare({"q", 1, {}}, SymbolKind::coordinate, 4, context.report);
  ValueReader values(context, Scope(context.sizes));
  CHECK(values.reference(value_syntax("q[3-2]"), SymbolKind::coordinate) == 4);
  CHECK_FALSE(values.reference(value_syntax("q[1]"), SymbolKind::point));
  CHECK_FALSE(values.reference(value_syntax("q[2]"), SymbolKind::coordinate));
  CHECK(context.report.errors() == 2);
}

ValueSyntax vector_of(std::size_t count) {
  ValueSyntax vector;
  vector.kind = ValueKind::list;
  vector.items.assign(count, value_syntax("x"));
  return vector;
}

TEST_CASE("all vectors of a model have as many components as the first") {
  const Limits limits;
  Context context(limits);
  ValueReader values(context, Scope(context.sizes));
  CHECK_FALSE(values.is_vector(vector_of(4)));
  CHECK(context.report.errors() == 1);
  CHECK(values.is_vector(vector_of(3)));
  CHECK(values.is_vector(vector_of(3)));
  CHECK(context.report.errors() == 1);
  CHECK(values.is_vector(vector_of(2)));
  CHECK(context.report.errors() == 2);
}

TEST_CASE("keys of tables are found by name") {
  ValueSyntax table;
  table.entries.push_back({"doc", {}, value_syntax("x")});
  CHECK(table.find("doc") != nullptr);
  CHECK(table.find("unit") == nullptr);
  CHECK(text_of(table, "doc") == "x");
  CHECK(text_of(table, "unit").empty());
  EntrySyntax entry;
  entry.keys = table.entries;
  CHECK(text_of(entry, "doc") == "x");
}

}  // namespace
}  // namespace elgen
