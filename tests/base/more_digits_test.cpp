// More digits add up while they live.
#include "base/more_digits.hpp"

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
