// The kinked functions of forces stay as written; nobody differentiates them.
#include <catch2/catch.hpp>

#include "elgen/lagrangian.hpp"

using namespace elgen;

TEST_CASE("kinked functions are opaque") {
  const GiNaC::realsymbol x("x"), y("y");
  CHECK(elgen_abs(-x).is_equal(elgen_abs(-x)));
  CHECK_FALSE(elgen_abs(-x).is_equal(elgen_abs(x)));
  CHECK(GiNaC::is_a<GiNaC::function>(GiNaC::ex(elgen_sign(GiNaC::ex(3)))));
  CHECK_FALSE(GiNaC::ex(elgen_min(x, y)).is_equal(elgen_max(x, y)));
}

TEST_CASE("a derivative of one is elgen's own mistake, and loud") {
  const GiNaC::realsymbol x("x"), y("y");
  CHECK_THROWS_AS(GiNaC::ex(elgen_abs(x)).diff(x), std::logic_error);
  CHECK_THROWS_AS(GiNaC::ex(elgen_sign(x)).diff(x), std::logic_error);
  CHECK_THROWS_AS(GiNaC::ex(elgen_min(x, y)).diff(x), std::logic_error);
  CHECK_THROWS_AS(GiNaC::ex(elgen_max(x, y)).diff(y), std::logic_error);
}
