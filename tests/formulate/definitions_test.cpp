// The list of definitions: atoms, repetition, order of symbols.
#include <catch2/catch.hpp>

#include "elgen/lagrangian.hpp"

using namespace elgen;
using GiNaC::ex;

TEST_CASE("symbols come leaves first, as declared, then definitions") {
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
