// Printing for people: names, sorted terms, brackets.
#include "formulate/print.hpp"

#include <catch2/catch.hpp>

using namespace elgen;

TEST_CASE("terms and factors are sorted, powers and functions bracketed") {
  Definitions definitions;
  const GiNaC::realsymbol b("b"), a("a"), x("x");
  add_leaf(definitions, b, Opcode::parameter);
  add_leaf(definitions, a, Opcode::parameter);
  add_leaf(definitions, x, Opcode::coordinate);
  const GiNaC::ex p = define(definitions, b * sin(x), {"p", {}});
  const ExpressionPrinter print(definitions);
  CHECK(print(x + b + a) == "a + b + x");
  CHECK(print(x * b * (a + x)) == "(a + x)*b*x");
  CHECK(print(pow(a + b, 2) * p) == "(a + b)^2*d0");
  CHECK(print(pow(x, GiNaC::numeric(-1, 2))) == "x^(-1/2)");
  CHECK(print(atan2(x, a)) == "atan2(x, a)");
  CHECK(dump(definitions) == "d0 = b*sin(x)    ; p\n");
}

TEST_CASE("signs stand in one place, wherever GiNaC keeps them") {
  Definitions definitions;
  const GiNaC::realsymbol a("a"), b("b"), k("k");
  for (const GiNaC::ex& leaf : std::vector<GiNaC::ex>{a, b, k}) {
    add_leaf(definitions, leaf, Opcode::coordinate);
  }
  const ExpressionPrinter print(definitions);
  CHECK(print((a - b) * k) == "(a - b)*k");
  CHECK(print((b - a) * k) == "-(a - b)*k");
  CHECK(print(pow(b - a, 2) * k) == "(a - b)^2*k");
  CHECK(print(pow(b - a, 3)) == "-(a - b)^3");
  CHECK(print(sqrt(b - a)) == "(-(a - b))^(1/2)");
  CHECK(print(b - a) == "-(a - b)");
  CHECK(print(-k / 2) == "-1/2*k");
  CHECK(print(sin(b - a)) == "sin(-(a - b))");
}
