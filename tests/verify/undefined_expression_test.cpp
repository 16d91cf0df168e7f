// The expression that takes an output's values away.
#include "verify/states/undefined_expression.hpp"

#include <catch2/catch.hpp>

#include "oracle/samples.hpp"

using namespace elgen;
using namespace elgen::test;

namespace {

std::string found(const std::string& potential, OutputKind kind = OutputKind::gravity) {
  ModelBuilder b;
  b.coordinate("x").parameter("m", "2").T("m*x_d^2").V(potential);
  Function function;
  function.kind = kind;
  std::vector<State> states;
  for (unsigned seed = 0; seed < 8; ++seed) states.push_back(random_state(b.model, seed));
  const auto id = undefined_expression(b.model, function, states);
  return id ? to_string(b.model, *id) : "";
}

}  // namespace

TEST_CASE("the innermost expression without a value at any state is named") {
  CHECK(found("x*log(sqrt(-1 - x^2))") == "sqrt(-1 - x^2)");
  CHECK(found("log(-exp(x))") == "log(-exp(x))");
  CHECK(found("sqrt(x)").empty());
  CHECK(found("m*x").empty());
}
