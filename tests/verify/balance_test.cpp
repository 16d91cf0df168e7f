// Balances: zero is zero relative to the terms, and undefined is no figure.
#include "verify/structure/balance.hpp"

#include <catch2/catch.hpp>

#include "support/real.hpp"

using namespace elgen;
using test::real;

TEST_CASE("the figure is the largest sum over the largest size of terms") {
  Balance balance(2);
  balance.add(0, real("3"));
  balance.add(0, real("-2"));
  balance.add(1, real("10"));
  balance.add(1, real("-10"));
  CHECK(balance.figure(Real()).value() == Approx(1.0 / 20));
  CHECK(balance.figure(real("30")).value() == Approx(1.0 / 50));
}

TEST_CASE("terms that are all zero balance") {
  Balance balance(1);
  balance.add(0, Real());
  CHECK(balance.figure(Real()) == 0.0);
}

TEST_CASE("rounding of something bigger is no difference") {
  Balance balance(1);
  balance.add(0, real("1e-64"));
  CHECK(balance.figure(Real()).value() == Approx(1));
  CHECK(balance.figure(real("1e-20")).value() < 1e-40);
}

TEST_CASE("an undefined term has no figure") {
  Balance balance(2);
  balance.add(0, real("1"));
  balance.add(1, Real::undefined());
  CHECK_FALSE(balance.figure(real("1")));
}
