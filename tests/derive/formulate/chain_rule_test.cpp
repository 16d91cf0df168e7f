// Tangents, gradients and substitutions through definitions, compared with GiNaC's derivatives of
// the written-out expression.
#include "derive/formulate/chain_rule.hpp"

#include <catch2/catch.hpp>

#include "derive/formulate/written_out.hpp"

using namespace elgen;
using namespace elgen::test;
using GiNaC::ex;

namespace {

/// Coordinates x and y, their rates v and w, time t, and definitions a to d; b, c and d use earlier
/// definitions.
struct Fixture {
  Definitions definitions;
  GiNaC::realsymbol x{"x"}, y{"y"}, v{"v"}, w{"w"}, t{"t"};
  ex a, b, c, d;

  Fixture() {
    for (const ex& leaf : std::vector<ex>{x, y}) add_leaf(definitions, leaf, Opcode::coordinate);
    for (const ex& leaf : std::vector<ex>{v, w}) add_leaf(definitions, leaf, Opcode::velocity);
    add_leaf(definitions, t, Opcode::time);
    a = define(definitions, x * sin(y), {"a", {}});
    b = define(definitions, a * a + cos(x * t) - y, {"b", {}});
    c = define(definitions, b / (1 + a * a), {"c", {}});
    d = define(definitions, c * b * v + sqrt(1 + w * w) * a, {"d", {}});
  }

  [[nodiscard]] bool agree(const ex& left, const ex& right) const {
    const ex difference = written_out(definitions, left - right);
    return vanishes(difference, {x, y, v, w, t});
  }
};

}  // namespace

TEST_CASE("equal values share one definition") {
  Fixture f;
  CHECK(define(f.definitions, f.x * sin(f.y)).is_equal(f.a));
  CHECK(define(f.definitions, -f.x).is_equal(-f.x));
  CHECK(define(f.definitions, ex(3)).is_equal(3));
  CHECK(f.definitions.list.size() == 4);
}

TEST_CASE("a definition knows the definitions and kinds of leaves that it uses") {
  const Fixture f;
  CHECK(f.definitions.list[1].used_definitions == std::vector<std::uint32_t>{0});
  CHECK(f.definitions.list[2].used_definitions == std::vector<std::uint32_t>{0, 1});
  CHECK(f.definitions.list[0].leaf_dependence == Opcode::coordinate);
  CHECK(f.definitions.list[1].leaf_dependence == (Opcode::coordinate | Opcode::time));
  CHECK(f.definitions.list[3].leaf_dependence ==
        (Opcode::coordinate | Opcode::time | Opcode::velocity));
}

TEST_CASE("a tangent is the derivative along its direction") {
  Fixture f;
  Tangent along(f.definitions, {{f.x, f.v}, {f.y, f.w}, {f.t, 1}}, "_dot");
  const ex rate = along(f.c);
  const ex whole = written_out(f.definitions, f.c);
  const ex expected = whole.diff(f.x) * f.v + whole.diff(f.y) * f.w + whole.diff(f.t);
  CHECK(f.agree(rate, expected));
}

TEST_CASE("a tangent along absent variables is zero") {
  Fixture f;
  Tangent along(f.definitions, {{f.w, 1}});
  CHECK(along(f.c).is_zero());
  CHECK(f.definitions.list.size() == 4);
}

TEST_CASE("a second tangent of a tangent is the second derivative") {
  Fixture f;
  Tangent along(f.definitions, {{f.x, 1}});
  const ex second = along(define(f.definitions, along(f.b)));
  CHECK(f.agree(second, written_out(f.definitions, f.b).diff(f.x, 2)));
}

TEST_CASE("a gradient has every partial derivative") {
  Fixture f;
  const auto slopes = gradient(f.definitions, {{f.d, 2}, {f.c * f.x, f.t}}, {f.x, f.y, f.v, f.w});
  const ex whole = written_out(f.definitions, 2 * f.d);
  const ex other = written_out(f.definitions, f.c * f.x);
  CHECK(f.agree(slopes[0], whole.diff(f.x) + f.t * other.diff(f.x)));
  CHECK(f.agree(slopes[1], whole.diff(f.y) + f.t * other.diff(f.y)));
  CHECK(f.agree(slopes[2], whole.diff(f.v)));
  CHECK(f.agree(slopes[3], whole.diff(f.w)));
}

TEST_CASE("a gradient skips terms of weight zero and absent variables") {
  Fixture f;
  const auto slopes = gradient(f.definitions, {{f.d, 0}, {f.a, 1}}, {f.x, f.w});
  CHECK(slopes[0].is_equal(sin(f.y)));
  CHECK(slopes[1].is_zero());
}

TEST_CASE("a substitution changes all definitions that it reaches and keeps the old ones") {
  Fixture f;
  Substitution still(f.definitions, {{f.t, 0}, {f.v, f.w}});
  const ex replaced = still(f.d);
  const ex whole = written_out(f.definitions, f.d);
  CHECK(f.agree(replaced, whole.subs(GiNaC::lst{f.t == 0, f.v == f.w})));
  CHECK(written_out(f.definitions, f.d).is_equal(whole));
  CHECK(still(f.a).is_equal(f.a));
}

TEST_CASE("partials of a long sum are in the order of definition, one for each symbol") {
  Fixture f;
  const auto found = partial_derivatives(f.definitions, f.b + f.x * f.y + f.x * f.v + 3,
                                         Opcode::parameter | Opcode::coordinate | Opcode::velocity);
  REQUIRE(found.size() == 4);
  CHECK(found[0].variable.is_equal(f.x));
  CHECK(found[0].value.is_equal(f.y + f.v));
  CHECK(found[1].variable.is_equal(f.y));
  CHECK(found[2].variable.is_equal(f.v));
  CHECK(found[3].variable.is_equal(f.b));
}

TEST_CASE("a chain of 20000 definitions is differentiated without recursion") {
  Fixture f;
  ex last = f.x;
  for (int i = 0; i < 20000; ++i) last = define(f.definitions, last * f.y + i);
  Tangent along(f.definitions, {{f.x, 1}});
  CHECK_FALSE(along(last).is_zero());
  CHECK_FALSE(gradient(f.definitions, {{last, 1}}, {f.x})[0].is_zero());
}
