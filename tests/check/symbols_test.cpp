// DeclaredNames: one set of names for all kinds of entries.
#include "check/names/symbols.hpp"

#include <catch2/catch.hpp>

namespace elgen {
namespace {

std::string only_message(const Report& report) {
  REQUIRE(report.sorted().size() == 1);
  const Diagnostic error = report.sorted().front();
  return std::string(code_row(error.code).name) + " " + error.message;
}

TEST_CASE("elements of one array are declared one by one") {
  DeclaredNames symbols;
  Report report;
  CHECK(symbols.declare({"q", 1, {}}, SymbolKind::coordinate, 0, report));
  CHECK(symbols.declare({"q", 2, {}}, SymbolKind::coordinate, 1, report));
  const DeclaredName* q = symbols.find("q");
  REQUIRE(q != nullptr);
  CHECK(q->is_array);
  CHECK(q->elements.at(2) == 1);
  CHECK_FALSE(symbols.declare({"q", 2, {}}, SymbolKind::coordinate, 2, report));
  CHECK(only_message(report) == "E203 `q[2]` is already a coordinate");
}

TEST_CASE("kinds share one set of names") {
  DeclaredNames symbols;
  Report report;
  CHECK(symbols.declare({"a", {}, {}}, SymbolKind::input, 0, report));
  CHECK_FALSE(symbols.declare({"a", {}, {}}, SymbolKind::point, 0, report));
  CHECK(only_message(report) == "E203 `a` is already an input");
}

TEST_CASE("a single name and an array cannot share it") {
  DeclaredNames symbols;
  Report report;
  CHECK(symbols.declare({"a", {}, {}}, SymbolKind::point, 0, report));
  CHECK_FALSE(symbols.declare({"a", 1, {}}, SymbolKind::point, 1, report));
  CHECK(only_message(report) == "E203 `a[1]` is already a point");
}

TEST_CASE("names that become one identifier are told apart from duplicates") {
  DeclaredNames symbols;
  Report report;
  CHECK(symbols.declare({"q_1", {}, {}}, SymbolKind::parameter, 0, report));
  CHECK_FALSE(symbols.declare({"q", 1, {}}, SymbolKind::coordinate, 0, report));
  CHECK(only_message(report) == "E211 `q[1]` and `q_1` both become `q_1` in code");
}

TEST_CASE("reserved and malformed names fail, and are remembered as failed") {
  DeclaredNames symbols;
  Report report;
  CHECK_FALSE(symbols.declare({"double", {}, {}}, SymbolKind::parameter, 0, report));
  CHECK(only_message(report) == "E204 `double` is reserved: it is a keyword of C++");
  CHECK(symbols.has_failed("double"));
  CHECK(symbols.find("double") == nullptr);
  Report second;
  CHECK_FALSE(symbols.declare({"p", -1, {}}, SymbolKind::point, 0, second));
  CHECK(only_message(second).substr(0, 4) == "E205");
}

TEST_CASE("a duplicate points at the first declaration, suggestions say what is meant") {
  const SourcePointer source = make_source("m.toml", "\nmass\nmass");
  DeclaredNames symbols;
  Report report;
  symbols.declare({"mass", {}, {source.get(), 1, 5}}, SymbolKind::parameter, 0, report);
  CHECK(symbols.suggest("mas", symbols.names()) == "did you mean `mass`? (parameter, line 2)");
  CHECK(symbols.suggest("mas", symbols.names({SymbolKind::point})).empty());
  CHECK(symbols.suggest("pj", {"pi"}) == "did you mean `pi`?");
  symbols.declare({"mass", {}, {source.get(), 6, 10}}, SymbolKind::point, 0, report);
  const Diagnostic error = report.sorted().front();
  REQUIRE(error.related);
  CHECK(error.related->begin == 1);
  CHECK(error.hint == "first at line 2");
}

}  // namespace
}  // namespace elgen
