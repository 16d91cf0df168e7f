// Translation of single expressions: values are kept, sizes stay small.
#include "formulate/expressions.hpp"

#include <catch2/catch.hpp>

#include "formulate/written_out.hpp"
#include "support/systems.hpp"

using namespace elgen;
using namespace elgen::test;
using GiNaC::ex;

namespace {

/// Written-out potential energy of a model of one coordinate x and one parameter k with the given
/// V.
ex translated(const std::string& text, Lagrangian& lagrangian) {
  const auto result = formulate(checked_model(model_text("one", R"toml(
[[coordinate]]
name = "x"
[parameters]
k = 2
E = { value = 1, doc = "without a unit, so that V has any" }
[energy]
T = "E*dot(x)^2/2"
V = "E*()toml" + text + ")\"\n"))
                                    .model);
  REQUIRE(result);
  lagrangian = *result;
  ex sum = 0;
  for (const ex& term : lagrangian.potential) sum += term;
  return written_out(lagrangian.definitions, sum) / lagrangian.symbols.parameters[1];
}

}  // namespace

TEST_CASE("every operation and function is translated") {
  Lagrangian l;
  const auto value = [&](const std::string& text) { return translated(text, l); };
  const auto x = [&] { return l.symbols.q[0]; };
  const auto k = [&] { return l.symbols.parameters[0]; };
  CHECK(value("-x^2*k/3").is_equal(-pow(x(), 2) * k() / 3));
  CHECK(value("x^(1/2) - 0.1").is_equal(sqrt(x()) - GiNaC::numeric(1, 10)));
  CHECK(value("sin(x) + cos(x) + tan(x)").is_equal(sin(x()) + cos(x()) + tan(x())));
  CHECK(value("asin(x)*acos(x)*atan(x)").is_equal(asin(x()) * acos(x()) * atan(x())));
  CHECK(value("atan2(x, k)").is_equal(atan2(x(), k())));
  CHECK(value("sinh(x) + cosh(x) + tanh(x)").is_equal(sinh(x()) + cosh(x()) + tanh(x())));
  CHECK(value("exp(x)*log(k)").is_equal(exp(x()) * log(k())));
  CHECK(value("pi*x").is_equal(GiNaC::Pi * x()));
}

TEST_CASE("a long sum becomes a tree of small definitions of the same value") {
  std::string text = "sin(x)";
  for (int i = 2; i < 200; ++i) text += " + sin(" + std::to_string(i) + "*x)/k";
  Lagrangian l;
  const ex whole = translated("(" + text + ")^2", l);
  ex sum = sin(l.symbols.q[0]);
  for (int i = 2; i < 200; ++i) sum += sin(i * l.symbols.q[0]) / l.symbols.parameters[0];
  CHECK(vanishes(whole - sum * sum, {l.symbols.q[0], l.symbols.parameters[0]}));
  for (const Definition& definition : l.definitions.list) {
    CHECK(symbols_of(l.definitions, definition.value).size() <= 10);
  }
}

TEST_CASE("nested functions do not nest in one definition") {
  std::string text = "x";
  for (int i = 0; i < 60; ++i) text = "sin(" + text + ")";
  Lagrangian l;
  CHECK_FALSE(translated(text, l).is_zero());
  CHECK(l.definitions.list.size() >= 5);
}
