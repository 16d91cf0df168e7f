// The random generator: known values, its ranges, and independence of the platform.
#include "numbers/random.hpp"

#include <catch2/catch.hpp>
#include <cmath>

using elgen::Random;

TEST_CASE("SplitMix64 gives the published sequence for seed 1234567") {
  Random random(1234567);
  CHECK(random.next() == 6457827717110365317U);
  CHECK(random.next() == 3203168211198807973U);
  CHECK(random.next() == 9817491932198370423U);
}

TEST_CASE("uniform numbers fill their interval") {
  Random random(1);
  double low = 3;
  double high = -2;
  for (int i = 0; i < 1000; ++i) {
    const double x = random.uniform(-2, 3);
    REQUIRE((x >= -2 && x < 3));
    low = std::fmin(low, x);
    high = std::fmax(high, x);
  }
  CHECK(low < -1.9);
  CHECK(high > 2.9);
}

TEST_CASE("log-uniform numbers cover both ends and both signs") {
  Random random(2);
  bool tiny = false;
  bool huge = false;
  bool negative = false;
  for (int i = 0; i < 1000; ++i) {
    const double x = random.log_uniform(-40, -11);
    REQUIRE((std::abs(x) >= 0x1p-40 && std::abs(x) < 0x1p-10));
    tiny = tiny || std::abs(x) < 0x1p-38;
    huge = huge || std::abs(x) > 0x1p-12;
    negative = negative || x < 0;
  }
  CHECK((tiny && huge && negative));
}

TEST_CASE("random rationals are exact, non-zero and at most 1 in magnitude") {
  Random random(3);
  for (int i = 0; i < 100; ++i) {
    const cln::cl_RA x = random.rational();
    REQUIRE_FALSE(cln::zerop(x));
    REQUIRE(cln::abs(x) <= 1);
    REQUIRE(cln::denominator(x) <= 997);
  }
}

TEST_CASE("equal seeds give equal sequences, different seeds do not") {
  Random a(7);
  Random b(7);
  Random c(8);
  const auto first = a.next();
  CHECK(first == b.next());
  CHECK(first != c.next());
}
