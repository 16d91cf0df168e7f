// More digits add up while they live.
#include "numbers/more_digits.hpp"

#include <catch2/catch.hpp>

using elgen::MoreDigits;

TEST_CASE("what lives adds up") {
  CHECK(MoreDigits::count() == 0);
  {
    const MoreDigits some(10);
    const MoreDigits more(64);
    CHECK(MoreDigits::count() == 74);
  }
  CHECK(MoreDigits::count() == 0);
}

TEST_CASE("what is lost is given back where it is more than can be spared") {
  MoreDigits digits;
  MoreDigits::lose(10);
  CHECK_FALSE(digits.grow());
  MoreDigits::lose(100);
  MoreDigits::lose(20);
  REQUIRE(digits.grow());
  CHECK(MoreDigits::count() == 100);
  MoreDigits::lose(105);
  CHECK_FALSE(digits.grow());
}
