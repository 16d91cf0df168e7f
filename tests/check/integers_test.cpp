// Integer arithmetic of indices, and the repetitions it bounds.
#include "check/names/integers.hpp"

#include <catch2/catch.hpp>

#include "check_testing.hpp"

namespace elgen {
namespace {

const Sizes sizes{{"n", 4}};

ExpressionSyntax parsed(const std::string& text) {
  static std::vector<SourcePointer> alive;
  alive.push_back(make_source("m.toml", text));
  auto result = parse_expression(alive.back(), {});
  REQUIRE(result);
  return *result;
}

std::string evaluated(const std::string& text) {
  Scope scope(sizes);
  scope.push("i", 2);
  Report report;
  const auto value = integer_value(parsed(text), scope, report);
  if (value) {
    CHECK(report.errors() == 0);
    return std::to_string(*value);
  }
  REQUIRE(report.errors() == 1);
  const Diagnostic error = report.sorted().front();
  return std::string(code_row(error.code).name) + " " + std::to_string(error.span.begin + 1) + " " +
         error.message + (error.hint.empty() ? "" : " | " + error.hint);
}

RangeSyntax range(const std::string& index, const std::string& low, const std::string& high) {
  return {index, parsed(low), parsed(high), {}, {}};
}

TEST_CASE("index expressions are integer arithmetic") {
  const test::Rows rows{
      {"3", "3"},
      {"i", "2"},
      {"n-i", "2"},
      {"2*n+1", "9"},
      {"-i", "-2"},
      {"max(i, n)", "4"},
      {"min(i, n)", "2"},
      {"i*i*n - 1", "15"},
      {"n/2", "E318 1 `n/2` is not integer arithmetic over sizes and indices"},
      {"1/2", "E318 1 `1/2` is not integer arithmetic over sizes and indices"},
      {"0.5", "E318 1 `0.5` is not integer arithmetic over sizes and indices"},
      {"i^2", "E318 1 `i^2` is not integer arithmetic over sizes and indices"},
      {"sin(i)", "E318 1 `sin(i)` is not integer arithmetic over sizes and indices"},
      {"1 + i[2]", "E318 5 `i[2]` is not integer arithmetic over sizes and indices"},
      {"i + j", "E201 5 unknown index `j`"},
      {"1e9*1e9*1e9", "E318 1 `1e9*1e9*1e9` is not integer arithmetic over sizes and indices"},
      {"1e10", "E318 1 `1e10` is not integer arithmetic over sizes and indices"},
  };
  test::check_rows(rows, [&](const std::string& text) { return evaluated(text); });
}

TEST_CASE("inner indices hide nothing that is still needed") {
  Scope scope(sizes);
  scope.push("i", 1);
  scope.push("i", 7);
  CHECK(scope.find("i") == 7);
  scope.pop();
  CHECK(scope.find("i") == 1);
  CHECK_FALSE(scope.find("k"));
}

TEST_CASE("repetitions run the last index fastest, later bounds may use earlier indices") {
  Scope scope(sizes);
  Report report;
  std::string order;
  const bool complete = repeat({range("a", "1", "n-1"), range("b", "a", "2")}, scope, report, [&] {
    order += std::to_string(*scope.find("a")) + std::to_string(*scope.find("b")) + " ";
    return true;
  });
  // a = 3 leaves b no element.
  CHECK_FALSE(complete);
  CHECK(order == "11 12 22 ");
  REQUIRE(report.errors() == 1);
  CHECK(report.sorted().front().code == Code::E209);
  CHECK(report.sorted().front().message == "from 3 to 2 there is no element");
  CHECK_FALSE(scope.find("a"));
}

TEST_CASE("a repetition ends where its body asks") {
  Scope scope(sizes);
  Report report;
  int count = 0;
  CHECK_FALSE(repeat({range("a", "0", "1000000000")}, scope, report, [&] { return ++count < 3; }));
  CHECK(count == 3);
}

}  // namespace
}  // namespace elgen
