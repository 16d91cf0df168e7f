// Jets: ring operations, quotients, powers of the graded symbol s, and functions by the chain rule.
#include "oracle/jet.hpp"

#include <rapidcheck.h>

#include <catch2/catch.hpp>

#include "oracle/real_functions.hpp"
#include "oracle/samples.hpp"

using namespace elgen;
using namespace elgen::oracle;
using cln::cl_R;
using cln::cl_RA;
using namespace elgen::test;

namespace {

constexpr Generators e0 = generator(0);
constexpr Generators e1 = generator(1);

/// A jet in three generators with small integer coefficients.
Jet random_jet() {
  Jet jet;
  for (Generators g = 0; g < 8; ++g) jet = jet + Jet(g, cl_R(*rc::gen::inRange(-3, 4)));
  return jet;
}

bool equal(const Jet& x, const Jet& y) { return (x - y).terms().empty(); }

/// The directional derivative of f by a central difference with h = 1e-20; the arguments stay in
/// the domain.
cl_R difference(FunctionId f, const cl_R& x, const cl_R& y, const cl_R& dx, const cl_R& dy) {
  JetFunctions functions;
  const auto at = [&](const cl_R& s) { return functions.value(f, x + s * dx, y + s * dy).real(); };
  const cl_R h = exact("1e-20");
  return (at(h) - at(-h)) / (2 * h);
}

}  // namespace

TEST_CASE("generators square to zero") {
  const Jet x = Jet(3) + Jet(e0, 1);
  const Jet square = x * x;
  CHECK(square.real() == 9);
  CHECK(square.coefficient(e0) == 6);
  CHECK(square.support() == e0);
}

TEST_CASE("magnitudes are the absolute values of all coefficients") {
  const Jet x = (Jet(-3) + Jet(e0, 2) + Jet(e1, -5)).absolute_coefficients();
  CHECK(x.real() == 3);
  CHECK(x.coefficient(e0) == 2);
  CHECK(x.coefficient(e1) == 5);
}

TEST_CASE("exact zeros are not stored as terms") {
  CHECK(Jet(0).terms().empty());
  CHECK(Jet(e0, 0).terms().empty());
  CHECK((Jet(e0, 1) - Jet(e0, 1)).terms().empty());
}

TEST_CASE("tangent and without decompose a jet by a generator") {
  const Jet x = Jet(2) + Jet(e0, 3) + Jet(e1, 5) + Jet(e0 | e1, 7);
  CHECK(equal(x.tangent(e1), Jet(5) + Jet(e0, 7)));
  CHECK(equal(x.without(e1), Jet(2) + Jet(e0, 3)));
  CHECK(equal(x.without(e1) + x.tangent(e1) * Jet(e1, 1), x));
}

TEST_CASE("second derivative of a quotient: 1/x at x = 2 is 1/4") {
  const Jet x = Jet(2) + Jet(e0, 1) + Jet(e1, 1);
  CHECK((Jet(1) / x).coefficient(e0 | e1) == cl_R(cl_RA(1) / cl_RA(4)));
}

TEST_CASE("division by a jet of value 0 throws, for any numerator") {
  CHECK_THROWS_AS(Jet(1) / Jet(0), OutsideDomain);
  CHECK_THROWS_AS(Jet(0) / Jet(0), OutsideDomain);
  CHECK_THROWS_AS(Jet(1) / Jet(e0, 1), OutsideDomain);
}

TEST_CASE("jets are a commutative ring, and division inverts multiplication") {
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

TEST_CASE("powers of s above the order vanish") {
  for (unsigned order = 1; order <= 6; ++order) {
    const Jet s(graded_symbol(order), 1);
    Jet power = 1;
    for (unsigned j = 0; j < order; ++j) power = power * s;
    CHECK(power.sum_grades().real() == 1);
    CHECK((power * s).terms().empty());
  }
}

TEST_CASE("the reciprocal of 1 - s is the geometric series") {
  const Jet s(graded_symbol(5), 1);
  const Jet sum = Jet(1) / (Jet(1) - s);
  CHECK(sum.sum_grades().real() == 6);
  const Jet with_generator = Jet(1) / (Jet(1) - s - Jet(e0, 1));
  CHECK(with_generator.part(e0).sum_grades().real() == 1 + 2 + 3 + 4 + 5 + 6);
}

TEST_CASE("first derivatives of smooth functions follow the table") {
  const cl_R x = exact("0.3");
  const cl_R y = 2;
  for (const FunctionRow& row : function_table()) {
    if (row.use == FunctionUse::forces_only) continue;
    JetFunctions functions;
    const Jet value = functions.value(row.id, Jet(x) + Jet(e0, 2), Jet(y) + Jet(e0, 3));
    CAPTURE(std::string(row.name));
    const cl_R dy = row.arity == 2 ? 3 : 0;
    CHECK(agree(value.coefficient(e0), difference(row.id, x, y, 2, dy), 36, 1));
  }
}

TEST_CASE("second derivatives are tangents of tangents") {
  JetFunctions functions;
  const cl_R x = exact("0.3");
  const Jet moved = Jet(x) + Jet(e0, 1) + Jet(e1, 1);
  const auto value = [&](FunctionId f) { return functions.value(f, x).real(); };
  const auto second = [&](FunctionId f) { return functions.value(f, moved).coefficient(e0 | e1); };
  CHECK(agree(second(FunctionId::sin), -value(FunctionId::sin), 90));
  CHECK(agree(second(FunctionId::exp), value(FunctionId::exp), 90));
  CHECK(agree(second(FunctionId::log), -1 / (x * x), 90));
  const cl_R tan = value(FunctionId::tan);
  CHECK(agree(second(FunctionId::tan), 2 * tan * (1 + tan * tan), 90));
}

TEST_CASE("kinked functions have no derivative") {
  JetFunctions functions;
  CHECK(functions.value(FunctionId::abs, Jet(-2) + Jet(e0, 1)).support() == 0);
}

TEST_CASE("integer powers exist everywhere, fractional powers above zero") {
  JetFunctions functions;
  const Jet minus_two = Jet(-2) + Jet(e0, 1);
  CHECK(functions.power(minus_two, 5).real() == -32);
  CHECK(functions.power(minus_two, 5).coefficient(e0) == 80);
  CHECK(functions.power(minus_two, -2).coefficient(e0) == exact("1/4"));
  CHECK(functions.power(minus_two, 0).real() == 1);
  CHECK_THROWS_AS(functions.power(minus_two, exact("1/2")), OutsideDomain);
  CHECK_THROWS_AS(functions.power(Jet(e0, 1), -1), OutsideDomain);
  CHECK_THROWS_AS(functions.power(0, 0), OutsideDomain);
}

TEST_CASE("the square root has a value at 0 and a derivative above 0") {
  JetFunctions functions;
  CHECK(functions.power(0, exact("1/2")).real() == 0);
  CHECK_THROWS_AS(functions.power(Jet(e0, 1), exact("1/2")), OutsideDomain);
  CHECK(functions.power(Jet(e0, 1), exact("3/2")).terms().empty());
  CHECK(functions.power(Jet(4) + Jet(e0, 1), exact("1/2")).coefficient(e0) == exact("1/4"));
}

TEST_CASE("sqrt(x^2 + y^2) at 0 has no derivative, but its square has") {
  JetFunctions functions;
  const cl_RA half = cl_RA(1) / 2;
  const Jet x(e0, 1);
  const Jet y(e1, 1);
  const Jet root = functions.power(x * x + y * y, half);
  CHECK(root.real() == 0);
  CHECK_THROWS_AS(root.coefficient(e0), OutsideDomain);
  CHECK_THROWS_AS(root.tangent(e1).real(), OutsideDomain);
  CHECK(root.without(e0 | e1).is_zero());
  CHECK((root * root).coefficient(e0) == 0);
  CHECK_THROWS_AS((root * root).coefficient(e0 | e1), OutsideDomain);
  CHECK_THROWS_AS((root - Jet(1)).coefficient(e0), OutsideDomain);
  CHECK((root * Jet(0)).is_zero());
  CHECK(functions.power(x * x + y * y, half * 3).coefficient(e0) == 0);
  CHECK(functions.value(FunctionId::cos, root).coefficient(e0) == 0);
  CHECK_THROWS_AS(functions.value(FunctionId::exp, root).coefficient(e0), OutsideDomain);
  CHECK(functions.power(Jet(4) + x * x, half).coefficient(e0) == 0);
}

TEST_CASE("sqrt(f^2) with df = 0 at 0 has a derivative") {
  JetFunctions functions;
  const cl_RA half = cl_RA(1) / 2;
  const Jet versine = Jet(1) - functions.value(FunctionId::cos, Jet(e0, 1));
  CHECK(functions.power(versine * versine, half).coefficient(e0) == 0);
  CHECK_THROWS_AS(functions.power(versine, half).coefficient(e0), OutsideDomain);
  const Jet sine = functions.value(FunctionId::sin, Jet(e0, 1));
  CHECK_THROWS_AS(functions.power(sine * sine, half).coefficient(e0), OutsideDomain);
}

TEST_CASE("a jet with zero tangent has no kink") {
  JetFunctions functions;
  const Jet still = Jet(e0, 1) * Jet(0);
  CHECK(functions.power(still, cl_RA(1) / 2).coefficient(e0) == 0);
  CHECK(functions.value(FunctionId::acos, Jet(1) + still).coefficient(e0) == 0);
  CHECK_THROWS_AS(functions.value(FunctionId::acos, Jet(1) + Jet(e0, 1)), OutsideDomain);
}

TEST_CASE("functions of s are their Taylor polynomials") {
  JetFunctions functions;
  const Jet s(graded_symbol(4), 1);
  // At s = 1: 1 - 1/2 + 1/24, and 1 + 1/2 - 1/8 + 1/16 - 5/128.
  const Jet cosine = functions.value(FunctionId::cos, s);
  CHECK(cln::abs(cosine.sum_grades().real() - cln::cl_RA(13) / 24) < cln::expt(cl_R(10), -50));
  const Jet root = functions.power(Jet(1) + s, cln::cl_RA(1) / 2);
  CHECK(cln::abs(root.sum_grades().real() - cln::cl_RA(179) / 128) < cln::expt(cl_R(10), -50));
  // cos(s^2) = 1 - s^4/2 at order 4.
  const Jet even = functions.value(FunctionId::cos, s * s);
  CHECK(cln::abs(even.sum_grades().real() - cln::cl_RA(1) / 2) < cln::expt(cl_R(10), -50));
}
