// The angle in a product of atoms.
#include "choose/monomial_angle.hpp"

#include <catch2/catch.hpp>

using namespace elgen;

TEST_CASE("circular atoms are the angle of a monomial, the others its powers") {
  Algebra algebra;
  algebra.atoms = {{.kind = AtomKind::leaf}, {.kind = AtomKind::circular}};
  const auto [powers, angle] = split(algebra, {{0, 2}, {1, -6}});
  CHECK(powers == Monomial{{0, 2}});
  CHECK(angle == Monomial{{1, -6}});
}

TEST_CASE("a direction has no common divisor, and its first part is positive") {
  CHECK(common_divisor({{1, -6}, {2, 4}}) == 2);
  CHECK(common_divisor({}) == 0);
  CHECK(direction({{1, -6}, {2, 4}}) == Monomial{{1, 3}, {2, -2}});
}

TEST_CASE("(c + i s)(c - i s) = c^2 + s^2") {
  const TwoPowers one{{{0, 0}, Gaussian{1, 0}}};
  const TwoPowers square = times_exponential(times_exponential(one, 1), -1);
  REQUIRE(square.size() == 2);
  CHECK(square.at({2, 0}).real == 1);
  CHECK(square.at({0, 2}).real == 1);
}
