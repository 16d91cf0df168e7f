// Resolver, operators: exponents, folding, limits.
#include "check/expressions/resolver.hpp"

#include <catch2/catch.hpp>
#include <utility>

#include "check_testing.hpp"

namespace elgen::test {
namespace {

std::string block_potential(const std::string& text, const Wanted& wanted = {}) {
  return dumped(block("V = \"" + text + "\"\n"), "energy V", wanted);
}

TEST_CASE("numbers fold, everything else stays as written") {
  const std::vector<std::pair<std::string, std::string>> rows{
      {"1/2*k*x^2", "1/2*k*x^2"},
      {"k*x^2 - (1/3 + 1/6)*k*x^2", "k*x^2 - 1/2*k*x^2"},
      {"k*x*x + 0*k*x^2", "k*x*x + 0*k*x^2"},
      {"k*x^2*sqrt(4)", "k*x^2*2"},
      {"k*x^2/2/3", "k*x^2/2/3"},
      {"-(k*x^2)", "-(k*x^2)"},
  };
  for (const auto& [text, printed] : rows) {
    CHECK(block_potential(text) == "energy V = " + printed + "\n");
  }
}

TEST_CASE("exponents are rational constants") {
  CHECK(block_potential("k*x^(4/2)") == "energy V = k*x^2\n");
  CHECK(block_potential("k*x^(5-3)") == "energy V = k*x^2\n");
  CHECK(block_potential("k*x^(3/2)*x^0.5") == "energy V = k*x^(3/2)*sqrt(x)\n");
  CHECK(potential_messages("k^x") ==
        "E311 12:8 `x` is not a rational constant | write exp(y*log(x)) for x^y\n");
  CHECK(potential_messages("k^pi").substr(0, 9) == "E311 12:8");
  // Only the outermost exponent that varies is named.
  CHECK(potential_messages("k^x^m").substr(0, 17) == "E311 12:8 `x^m` i");
  CHECK(potential_messages("k^xx").substr(0, 9) == "E201 12:8");
}

TEST_CASE("powers have a limit, at which they are still allowed") {
  CHECK(messages(block("V = \"k*x^2*(x/x)^64\"\n")).empty());
  CHECK(potential_messages("k*x^65") == "E905 12:10 `65` is beyond the limit 64\n");
  CHECK(potential_messages("k*x^-65").substr(0, 4) == "E905");
  CHECK(potential_messages("k*x^(1/65)") == "E905 12:10 `(1/65)` is beyond the limit 64\n");
  CHECK(potential_messages("2^(2^100)").substr(0, 10) == "E905 12:11");
  Limits limits;
  limits.integer_power = 65;
  CHECK(messages(block("V = \"k*x^2*(x/x)^65\"\n"), {{}, {}, {}, {}, limits, false}).empty());
}

TEST_CASE("the nodes of all expressions together have a limit, reported once") {
  Limits limits;
  limits.derived_nodes = 50;
  const std::string model = block("V = \"sum(i, 1, 100, k*x^2)\"\nD = \"sum(i, 1, 100, m)\"\n");
  CHECK(messages(model, {{}, {}, {}, {}, limits, false}) ==
        "E908 12:25 the expressions have more than 50 nodes after repetition\n");
}

TEST_CASE("sums that would never end are stopped") {
  CHECK(potential_messages("sum(i, 1, 1000000000, sum(j, 1, 1000000000, k*x^2))").substr(0, 4) ==
        "E908");
}

TEST_CASE("a duplicate error of two terms is told twice, with two places") {
  CHECK(potential_messages("foo + bar") ==
        "E201 12:6 unknown name `foo`\nE201 12:12 unknown name `bar`\n");
}

}  // namespace
}  // namespace elgen::test
