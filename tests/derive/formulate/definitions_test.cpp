// The list of definitions: atoms, shared values, order of symbols, text, and opaque functions.
#include <catch2/catch.hpp>

#include "elgen/lagrangian.hpp"

using namespace elgen;
using GiNaC::ex;

TEST_CASE("symbols are ordered: leaves in order of declaration, then definitions") {
  Definitions definitions;
  const GiNaC::realsymbol z("z"), a("a");
  add_leaf(definitions, z, Opcode::parameter);
  add_leaf(definitions, a, Opcode::coordinate);
  const ex p = define(definitions, a * a);
  const ex r = define(definitions, z + p);
  const auto symbols = symbols_of(definitions, r * p + a * sin(z) + a);
  REQUIRE(symbols.size() == 4);
  CHECK(symbols[0].is_equal(z));
  CHECK(symbols[1].is_equal(a));
  CHECK(symbols[2].is_equal(p));
  CHECK(symbols[3].is_equal(r));
  CHECK(dependence(definitions, r) == (Opcode::parameter | Opcode::coordinate));
  CHECK(dependence(definitions, ex(4)) == LeafSet());
}

TEST_CASE("numbers, symbols and their negatives need no definition") {
  Definitions definitions;
  const GiNaC::realsymbol a("a");
  add_leaf(definitions, a, Opcode::coordinate);
  CHECK(define(definitions, GiNaC::numeric(2, 3)).is_equal(GiNaC::numeric(2, 3)));
  CHECK(define(definitions, a).is_equal(a));
  CHECK(define(definitions, -a).is_equal(-a));
  CHECK(definitions.list.empty());
  define(definitions, 2 * a, {"twice", {}});
  REQUIRE(definitions.list.size() == 1);
  CHECK(definitions.list[0].name == "twice");
}

TEST_CASE("terms and factors are sorted, powers and functions bracketed") {
  Definitions definitions;
  const GiNaC::realsymbol b("b"), a("a"), x("x");
  add_leaf(definitions, b, Opcode::parameter);
  add_leaf(definitions, a, Opcode::parameter);
  add_leaf(definitions, x, Opcode::coordinate);
  const GiNaC::ex p = define(definitions, b * sin(x), {"p", {}});
  const auto print = [&](const ex& value) { return expression_text(definitions, value); };
  CHECK(print(x + b + a) == "a + b + x");
  CHECK(print(x * b * (a + x)) == "(a + x)*b*x");
  CHECK(print(pow(a + b, 2) * p) == "(a + b)^2*d0");
  CHECK(print(pow(x, GiNaC::numeric(-1, 2))) == "x^(-1/2)");
  CHECK(print(atan2(x, a)) == "atan2(x, a)");
  CHECK(dump(definitions) == "d0 = b*sin(x)    ; p\n");
}

TEST_CASE("factored signs are printed in a canonical place, wherever GiNaC keeps them") {
  Definitions definitions;
  const GiNaC::realsymbol a("a"), b("b"), k("k");
  for (const GiNaC::ex& leaf : std::vector<GiNaC::ex>{a, b, k}) {
    add_leaf(definitions, leaf, Opcode::coordinate);
  }
  const auto print = [&](const ex& value) { return expression_text(definitions, value); };
  CHECK(print((a - b) * k) == "(a - b)*k");
  CHECK(print((b - a) * k) == "-(a - b)*k");
  CHECK(print(pow(b - a, 2) * k) == "(a - b)^2*k");
  CHECK(print(pow(b - a, 3)) == "-(a - b)^3");
  CHECK(print(sqrt(b - a)) == "(-(a - b))^(1/2)");
  CHECK(print(b - a) == "-(a - b)");
  CHECK(print(-k / 2) == "-1/2*k");
  CHECK(print(sin(b - a)) == "sin(-(a - b))");
}

TEST_CASE("kinked functions are opaque") {
  const GiNaC::realsymbol x("x"), y("y");
  CHECK(elgen_abs(-x).is_equal(elgen_abs(-x)));
  CHECK_FALSE(elgen_abs(-x).is_equal(elgen_abs(x)));
  CHECK(GiNaC::is_a<GiNaC::function>(GiNaC::ex(elgen_sign(GiNaC::ex(3)))));
  CHECK_FALSE(GiNaC::ex(elgen_min(x, y)).is_equal(elgen_max(x, y)));
}

TEST_CASE("the derivative of a kinked function throws logic_error") {
  const GiNaC::realsymbol x("x"), y("y");
  CHECK_THROWS_AS(GiNaC::ex(elgen_abs(x)).diff(x), std::logic_error);
  CHECK_THROWS_AS(GiNaC::ex(elgen_sign(x)).diff(x), std::logic_error);
  CHECK_THROWS_AS(GiNaC::ex(elgen_min(x, y)).diff(x), std::logic_error);
  CHECK_THROWS_AS(GiNaC::ex(elgen_max(x, y)).diff(y), std::logic_error);
}
