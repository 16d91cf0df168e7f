#include "oracle/jet.hpp"

#include <rapidcheck.h>

#include <catch2/catch.hpp>

#include "oracle/generators.hpp"
#include "oracle/real_functions.hpp"

using namespace elgen::oracle;
using cln::cl_R;
using cln::cl_RA;
using elgen::test::e0;
using elgen::test::e1;

namespace {

/// A jet in three generators with small exact coefficients.
Jet random_jet() {
  Jet jet;
  for (Generators g = 0; g < 8; ++g) jet = jet + Jet(g, cl_R(*rc::gen::inRange(-3, 4)));
  return jet;
}

bool equal(const Jet& x, const Jet& y) { return (x - y).terms().empty(); }

}  // namespace

TEST_CASE("generators square to zero") {
  const Jet x = Jet(3) + Jet(e0, 1);
  const Jet square = x * x;
  CHECK(square.real() == 9);
  CHECK(square.coefficient(e0) == 6);
  CHECK(square.support() == e0);
}

TEST_CASE("magnitudes are those of every coefficient") {
  const Jet x = (Jet(-3) + Jet(e0, 2) + Jet(e1, -5)).magnitudes();
  CHECK(x.real() == 3);
  CHECK(x.coefficient(e0) == 2);
  CHECK(x.coefficient(e1) == 5);
}

TEST_CASE("exact zeros are no terms") {
  CHECK(Jet(0).terms().empty());
  CHECK(Jet(e0, 0).terms().empty());
  CHECK((Jet(e0, 1) - Jet(e0, 1)).terms().empty());
}

TEST_CASE("tangent and without split a jet by a generator") {
  const Jet x = Jet(2) + Jet(e0, 3) + Jet(e1, 5) + Jet(e0 | e1, 7);
  CHECK(equal(x.tangent(e1), Jet(5) + Jet(e0, 7)));
  CHECK(equal(x.without(e1), Jet(2) + Jet(e0, 3)));
  CHECK(equal(x.without(e1) + x.tangent(e1) * Jet(e1, 1), x));
}

TEST_CASE("second derivative of a quotient: 1/x at x = 2 is 1/4") {
  const Jet x = Jet(2) + Jet(e0, 1) + Jet(e1, 1);
  CHECK((Jet(1) / x).coefficient(e0 | e1) == cl_R(cl_RA(1) / cl_RA(4)));
}

TEST_CASE("division by zero is outside the domain, for any numerator") {
  CHECK_THROWS_AS(Jet(1) / Jet(0), OutsideDomain);
  CHECK_THROWS_AS(Jet(0) / Jet(0), OutsideDomain);
  CHECK_THROWS_AS(Jet(1) / Jet(e0, 1), OutsideDomain);
}

TEST_CASE("jets are a commutative ring, and quotients undo products") {
  CHECK(rc::check("ring laws", [] {
    const Jet x = random_jet();
    const Jet y = random_jet();
    const Jet z = random_jet();
    RC_ASSERT(equal(x * y, y * x));
    RC_ASSERT(equal((x * y) * z, x * (y * z)));
    RC_ASSERT(equal(x * (y + z), x * y + x * z));
    if (y.real() != 0) RC_ASSERT(equal(x * y / y, x));
  }));
}

TEST_CASE("powers of s beyond the order vanish") {
  for (unsigned order = 1; order <= 6; ++order) {
    const Jet s(graded_symbol(order), 1);
    Jet power = 1;
    for (unsigned j = 0; j < order; ++j) power = power * s;
    CHECK(power.ungraded().real() == 1);
    CHECK((power * s).terms().empty());
  }
}

TEST_CASE("the reciprocal of 1 - s is the geometric series") {
  const Jet s(graded_symbol(5), 1);
  const Jet sum = Jet(1) / (Jet(1) - s);
  CHECK(sum.ungraded().real() == 6);
  const Jet with_generator = Jet(1) / (Jet(1) - s - Jet(e0, 1));
  CHECK(with_generator.part(e0).ungraded().real() == 1 + 2 + 3 + 4 + 5 + 6);
}
