// Expressions inside options: their spans point into the option.
#include "check/expressions/syntax_part.hpp"

#include <catch2/catch.hpp>

namespace elgen {
namespace {

TEST_CASE("a part keeps its place in the whole") {
  const SourcePointer source = make_source("command line", "g = 1 + h");
  Report report;
  const auto expression = parse_part({source.get(), 4, 9}, {}, report);
  REQUIRE(expression);
  CHECK(covered_text(expression->span) == "1 + h");
  CHECK(covered_text(expression->operands[1].span) == "h");
  CHECK(covered_text(expression->operands[1].token) == "h");
  CHECK(report.sorted().empty());
}

TEST_CASE("errors of a part point into the whole") {
  const SourcePointer source = make_source("command line", "g=(1+2");
  Report report;
  CHECK_FALSE(parse_part({source.get(), 2, 6}, {}, report));
  REQUIRE(report.errors() == 1);
  const Diagnostic error = report.sorted().front();
  CHECK(error.code == Code::E304);
  CHECK(error.span.source == source.get());
  CHECK(error.span.begin == 6);
  REQUIRE(error.related);
  CHECK(error.related->source == source.get());
  CHECK(error.related->begin == 2);
}

}  // namespace
}  // namespace elgen
