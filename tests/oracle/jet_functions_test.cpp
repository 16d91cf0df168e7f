#include "oracle/jet_functions.hpp"

#include <catch2/catch.hpp>

#include "oracle/generators.hpp"
#include "oracle/samples.hpp"

using namespace elgen;
using namespace elgen::oracle;
using namespace elgen::test;
using cln::cl_R;

namespace {

/// f(x + h), f(x - h): the derivative to h^2 by a central difference; arguments inside every
/// domain.
cl_R difference(FunctionId f, const cl_R& x, const cl_R& y, const cl_R& dx, const cl_R& dy) {
  JetFunctions functions;
  const auto at = [&](const cl_R& s) { return functions.value(f, x + s * dx, y + s * dy).real(); };
  const cl_R h = exact("1e-20");
  return (at(h) - at(-h)) / (2 * h);
}

}  // namespace

TEST_CASE("first derivatives of every smooth function are those of functions.def") {
  const cl_R x = exact("0.3");
  const cl_R y = exact("0.7");
  for (const FunctionRow& row : function_table) {
    if (row.use == FunctionUse::forces) continue;
    JetFunctions functions;
    const Jet value = functions.value(row.id, Jet(x) + Jet(e0, 2), Jet(y) + Jet(e0, 3));
    CAPTURE(std::string(row.name));
    const cl_R dy = row.arity == 2 ? 3 : 0;
    CHECK(agree(value.coefficient(e0), difference(row.id, x, y, 2, dy), 36, 1));
  }
}

TEST_CASE("second derivatives: the tangent of the tangent") {
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

TEST_CASE("powers: whole ones everywhere, broken ones above zero") {
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

TEST_CASE("the square root has a value at zero, and a derivative above it") {
  JetFunctions functions;
  CHECK(functions.power(0, exact("1/2")).real() == 0);
  CHECK_THROWS_AS(functions.power(Jet(e0, 1), exact("1/2")), OutsideDomain);
  CHECK(functions.power(Jet(e0, 1), exact("3/2")).terms().empty());
  CHECK(functions.power(Jet(4) + Jet(e0, 1), exact("1/2")).coefficient(e0) == exact("1/4"));
}

TEST_CASE("functions of s are their Taylor polynomials") {
  JetFunctions functions;
  const Jet s(graded_symbol(4), 1);
  // At s = 1: 1 - 1/2 + 1/24 and 1 + 1/2 - 1/8 + 1/16 - 5/128.
  const Jet cosine = functions.value(FunctionId::cos, s);
  CHECK(cln::abs(cosine.ungraded().real() - cln::cl_RA(13) / 24) < cln::expt(cl_R(10), -50));
  const Jet root = functions.power(Jet(1) + s, cln::cl_RA(1) / 2);
  CHECK(cln::abs(root.ungraded().real() - cln::cl_RA(179) / 128) < cln::expt(cl_R(10), -50));
  // x^2 s^2 only: cos(s^2) = 1 - s^4/2
  const Jet even = functions.value(FunctionId::cos, s * s);
  CHECK(cln::abs(even.ungraded().real() - cln::cl_RA(1) / 2) < cln::expt(cl_R(10), -50));
}
