// What helps beside a message about units: the number without a name, the declaration of a name.
#include "check/expressions/unit_mismatch.hpp"

#include <catch2/catch.hpp>

#include "check_testing.hpp"

namespace elgen::test {
namespace {

/// The diagnostic of the model `block` with this V.
Diagnostic unit_error(const std::string& potential) {
  const Result<CheckedModel> result = run_check(block("V = \"" + potential + "\"\n"));
  REQUIRE(!result.diagnostics.empty());
  return result.diagnostics.front();
}

TEST_CASE("an error of units points to the declaration of the first parameter") {
  const Diagnostic sum = unit_error("1/2*k*x^2 + x*k");
  CHECK(sum.related_message == "`k` is declared here, in N/m");
  REQUIRE(sum.related);
  CHECK(covered_text(*sum.related) == "k");
  CHECK(unit_error("1/2*k*x^2 + x").related_message == "`x` is declared here, in m");
  CHECK(unit_error("1/2*k*x^2 + dot(x)").related_message == "`x` is declared here, in m");
  CHECK(unit_error("1/2*k*x^2 + t").related_message.empty());
}

TEST_CASE("a number beside names has no unit, 0 needs none") {
  CHECK(unit_error("k*x^2*(x + 3*x/x)").hint ==
        "`3` has no unit in an expression: give it a name and a unit in `[parameters]`");
  CHECK(unit_error("k*x^2*(x + x/x)").hint.empty());
}

}  // namespace
}  // namespace elgen::test
