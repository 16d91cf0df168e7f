// Sums and products without what is 0 or 1.
#include "urdf/expressions.hpp"

#include <catch2/catch.hpp>

namespace elgen::test {

TEST_CASE("a sum leaves out 0, and knows minus") {
  CHECK(urdf::sum("0", "q") == "q");
  CHECK(urdf::sum("x", "0") == "x");
  CHECK(urdf::sum("x", "q") == "x + q");
  CHECK(urdf::sum("x", "-q") == "x - q");
  CHECK(urdf::sum("x", "-(a*q + b)") == "x - (a*q + b)");
}

TEST_CASE("a product leaves out 1, and brackets sums") {
  CHECK(urdf::product("0", "q") == "0");
  CHECK(urdf::product("1", "q") == "q");
  CHECK(urdf::product("-1", "q") == "-q");
  CHECK(urdf::product("0.6", "q") == "0.6*q");
  CHECK(urdf::product("0.6", "a*q + b") == "0.6*(a*q + b)");
  CHECK(urdf::product("-0.6", "-q") == "-0.6*(-q)");
}

TEST_CASE("a quotient leaves out 1, and brackets sums") {
  CHECK(urdf::quotient("0", "l") == "0");
  CHECK(urdf::quotient("q + b", "1") == "q + b");
  CHECK(urdf::quotient("-0.7*q", "l") == "-0.7*q/l");
  CHECK(urdf::quotient("q + b", "l") == "(q + b)/l");
  CHECK(urdf::quotient("-q + b", "l") == "(-q + b)/l");
  CHECK(urdf::quotient("0.7*(q + b)", "l") == "0.7*(q + b)/l");
}

TEST_CASE("a sign turns what it stands before") {
  CHECK(urdf::negated("q") == "-q");
  CHECK(urdf::negated("-q") == "q");
  CHECK(urdf::negated("a*q + b") == "-(a*q + b)");
  CHECK(urdf::negated("-q + b") == "-(-q + b)");
  CHECK(urdf::negated("0") == "0");
}

TEST_CASE("a coupling is a position and a rate") {
  const urdf::Coupling coupling{"q", "ratio", "offset"};
  CHECK(coupling.position() == "ratio*q + offset");
  CHECK(coupling.rate() == "ratio*dot(q)");
  CHECK(urdf::Coupling{"q"}.position() == "q");
  CHECK(urdf::Coupling{"q", "-1", "b"}.position() == "-q + b");
  CHECK(urdf::Coupling{"q", "0", "b"}.position() == "b");
}

}  // namespace elgen::test
