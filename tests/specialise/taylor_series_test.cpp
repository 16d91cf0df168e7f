// Taylor coefficients through definitions, against GiNaC's own series of what is written out.
#include "specialise/taylor_series.hpp"

#include <catch2/catch.hpp>

#include "formulate/written_out.hpp"

using namespace elgen;
using namespace elgen::test;
using GiNaC::ex;

namespace {

/// Leaves x, y and definitions over them.
struct Leaves {
  Definitions definitions;
  ex x = GiNaC::realsymbol("x");
  ex y = GiNaC::realsymbol("y");
  ex p = GiNaC::realsymbol("p");

  Leaves() {
    add_leaf(definitions, p, Opcode::parameter);
    add_leaf(definitions, x, Opcode::coordinate);
    add_leaf(definitions, y, Opcode::velocity);
  }

  ex expanded(const ex& value, const std::vector<SmallLeaf>& small, unsigned order) {
    TaylorSeries series(definitions, small, order);
    return written_out(definitions, series(value)).expand();
  }
};

}  // namespace

TEST_CASE("an expansion is the Taylor polynomial about the point") {
  Leaves l;
  const ex h = define(l.definitions, l.p * cos(l.x));
  CHECK(l.expanded(h, {{l.x, 0}}, 3).is_equal(l.p - l.p * pow(l.x, 2) / 2));
  const ex about = GiNaC::Pi / 2;
  const ex expected = (-l.p * (l.x - about) + l.p * pow(l.x - about, 3) / 6).expand();
  CHECK(l.expanded(h, {{l.x, about}}, 4).is_equal(expected));
}

TEST_CASE("orders of all small leaves count jointly, through products and quotients") {
  Leaves l;
  const ex a = define(l.definitions, exp(l.x) * l.y);
  const ex b = define(l.definitions, l.p + l.x);
  const ex value = a / b;
  const std::vector<SmallLeaf> small{{l.x, 0}, {l.y, 0}};
  // y (1 + x + x^2/2) (1/p - x/p^2 + x^2/p^3)
  const ex third = l.y / l.p + l.x * l.y * (1 / l.p - 1 / pow(l.p, 2)) +
                   pow(l.x, 2) * l.y * (1 / (2 * l.p) - 1 / pow(l.p, 2) + 1 / pow(l.p, 3));
  CHECK((l.expanded(value, small, 3) - third).expand().is_zero());
}

TEST_CASE("what is not small stays as it is") {
  Leaves l;
  const ex h = define(l.definitions, sin(l.x) * pow(l.y, 2));
  CHECK(l.expanded(h, {{l.y, 0}}, 1).is_zero());
  CHECK(l.expanded(h, {{l.y, 0}}, 2).is_equal(sin(l.x) * pow(l.y, 2)));
  CHECK(l.expanded(sin(l.p), {{l.x, 0}}, 1).is_equal(sin(l.p)));
}

TEST_CASE("a value without derivatives at the point is refused") {
  Leaves l;
  const ex root = define(l.definitions, sqrt(l.x) + l.p);
  CHECK_THROWS_AS(l.expanded(root, {{l.x, 0}}, 1), GiNaC::pole_error);
}
