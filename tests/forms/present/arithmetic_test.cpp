#include "forms/present/arithmetic.hpp"

#include <catch2/catch.hpp>

#include "forms/present/polynomial.hpp"

using namespace elgen;

namespace {

struct Leaves {
  Algebra algebra = {};
  Arithmetic arithmetic{algebra};
  OptionalFraction x = arithmetic.leaf(Opcode::coordinate, 0);
  OptionalFraction y = arithmetic.leaf(Opcode::coordinate, 1);

  bool equal(const OptionalFraction& a, const OptionalFraction& b) {
    const OptionalFraction difference = arithmetic.add(a, arithmetic.negate(b));
    return difference && difference->numerator.empty();
  }
};

}  // namespace

TEST_CASE("a factor in the denominator cancels with an equal factor") {
  Leaves l;
  Arithmetic& a = l.arithmetic;
  const OptionalFraction sum = a.add(l.x, l.y);
  const OptionalFraction quotient = a.divide(l.x, sum);
  REQUIRE(quotient);
  CHECK(quotient->denominator.size() == 1);
  const OptionalFraction product = a.multiply(quotient, sum);
  REQUIRE(product);
  CHECK(product->denominator.empty());
  CHECK(l.equal(product, l.x));
}

TEST_CASE("factors of denominators are identified up to a monomial") {
  Leaves l;
  Arithmetic& a = l.arithmetic;
  const OptionalFraction sum = a.add(l.x, l.y);
  (void)a.divide(l.x, sum);
  (void)a.divide(l.y, a.multiply(sum, a.multiply(l.x, fraction_of(cln::cl_RA(3)))));
  CHECK(l.algebra.factors.size() == 1);
}

TEST_CASE("division by zero and an exhausted budget give no value") {
  Leaves l;
  CHECK_FALSE(l.arithmetic.divide(l.x, Fraction{}));
  std::size_t little = 3;
  Arithmetic exhausted(l.algebra, little, 1000);
  const OptionalFraction sum = l.arithmetic.add(l.x, l.y);
  CHECK_FALSE(exhausted.multiply(sum, sum));
  CHECK_FALSE(exhausted.add(exhausted.multiply(sum, sum), l.x));
}

TEST_CASE("equal atoms are identified") {
  Leaves l;
  CHECK(l.equal(l.arithmetic.leaf(Opcode::coordinate, 0), l.x));
  CHECK(l.algebra.atoms.size() == 2);
}

TEST_CASE("integer powers of either sign") {
  Leaves l;
  Arithmetic& a = l.arithmetic;
  CHECK(l.equal(a.multiply(a.power(l.x, -2), a.power(l.x, 3)), l.x));
  CHECK(l.equal(a.power(l.x, 0), fraction_of(cln::cl_RA(1))));
}
