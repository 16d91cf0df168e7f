// Compares the derivative of every function of dual numbers with central differences in 64 digits,
// and tests nested dual numbers.
#include "numbers/dual.hpp"

#include <catch2/catch.hpp>

#include "elgen/functions.hpp"
#include "support/real.hpp"

using namespace elgen;
using namespace elgen::test;

namespace {

/// |x - y| as a double.
double apart(const Real& x, const Real& y) { return to_double(abs(x - y).value()); }

}  // namespace

TEST_CASE("the slope of a smooth function is its derivative") {
  const Real x = real("3/7");
  const Real y = real("2");
  const Real h = real("1/100000000000000000000");
  for (const FunctionRow& row : function_table()) {
    if (row.use == FunctionUse::forces_only) continue;
    INFO(row.name);
    const Dual<Real> dual = interpreter::call<Dual<Real>>(row.id, {x, Real(1)}, {y, Real()});
    const Real right = interpreter::call(row.id, x + h, y);
    const Real left = interpreter::call(row.id, x - h, y);
    // The error of a central difference is h^2/6 |f'''| < 1e-40 |f'''|, and |f'''| < 100 here.
    CHECK(apart(dual.slope, (right - left) / (h + h)) < 1e-38);
    CHECK(apart(dual.value, interpreter::call(row.id, x, y)) == 0);
  }
}

TEST_CASE("dual numbers of double have slopes, and kinked functions have slope 0") {
  for (const FunctionRow& row : function_table()) {
    INFO(row.name);
    const Dual<double> dual = interpreter::call<Dual<double>>(row.id, {0.4, 1}, {1.25, 0});
    CHECK(dual.value == interpreter::call(row.id, 0.4, 1.25));
    if (row.use == FunctionUse::forces_only) {
      CHECK(dual.slope == 0);
      continue;
    }
    const Real exact =
        interpreter::call<Dual<Real>>(row.id, {real("2/5"), Real(1)}, {real("5/4"), Real()}).slope;
    CHECK(dual.slope == Approx(to_double(exact.value())));
  }
  CHECK(sqrt(Dual<double>{4, 1}).slope == 0.25);
}

TEST_CASE("atan2 has a derivative by its second argument") {
  // d/dx atan2(y, x) = -y / (x^2 + y^2) at (3, 4)
  const Dual<Real> angle = atan2(Dual<Real>{real("3"), Real()}, Dual<Real>{real("4"), Real(1)});
  CHECK(apart(angle.slope, real("-3/25")) < 1e-60);
}

TEST_CASE("products, quotients and roots follow the product and chain rules") {
  const Dual<Real> x{real("4"), Real(1)};
  const Dual<Real> three = ScalarTraits<Dual<Real>>::from_real(3);
  CHECK(apart((x * x - three).slope, real("8")) < 1e-60);
  CHECK(apart((three / x).slope, real("-3/16")) < 1e-60);
  CHECK(apart((-sqrt(x)).slope, real("-1/4")) < 1e-60);
}

TEST_CASE("nested duals give second derivatives") {
  const Dual<Real> inner{real("2"), Real(1)};
  const Dual<Dual<Real>> x{inner, {Real(1), Real()}};
  CHECK(apart((x * x * x).slope.slope, real("12")) < 1e-60);
  CHECK(apart(sin(x).slope.slope, -sin(real("2"))) < 1e-60);
}

TEST_CASE("dual arguments combine a point and a direction") {
  const Arguments<Real> point{.q = {real("1")}, .v = {real("2")}, .t = real("3")};
  const Arguments<Real> direction{.q = {real("4")}, .v = {real("5")}, .t = real("6")};
  const Arguments<Dual<Real>> moved = dual_leaves(point, direction);
  CHECK(apart(moved.q[0].slope, real("4")) == 0);
  CHECK(apart(moved.v[0].value, real("2")) == 0);
  CHECK(apart(moved.t.slope, real("6")) == 0);
}
