// Powers of ten, and binary numbers as rationals.
#include "base/exact_number.hpp"

#include <cln/rational.h>
#include <cln/rational_io.h>

#include <catch2/catch.hpp>
#include <limits>

using namespace elgen;

TEST_CASE("binary numbers become the rationals they are, denormals too") {
  CHECK(exact_value(0.1) == cln::cl_R("3602879701896397/36028797018963968"));
  CHECK(exact_value(-6.5) == cln::cl_R("-13/2"));
  CHECK(exact_value(0) == 0);
  const cln::cl_RA smallest = 1 / cln::expt(cln::cl_RA(2), 1074);
  CHECK(exact_value(std::numeric_limits<double>::denorm_min()) == smallest);
}

TEST_CASE("the largest number counts by its magnitude") {
  CHECK(largest_of({}) == 0);
  CHECK(largest_of({1, -3, 2}) == 3);
}

TEST_CASE("powers of ten are exact in both directions") {
  CHECK(power_of_ten(0) == 1);
  CHECK(power_of_ten(3) == 1000);
  CHECK(power_of_ten(-400) * power_of_ten(400) == 1);
}

TEST_CASE("decimal exponents of numbers of any size") {
  CHECK(decimal_exponent(0) == 0);
  CHECK(decimal_exponent(power_of_ten(5000)) == Approx(5000).margin(1));
  CHECK(decimal_exponent(cln::pi()) == Approx(0).margin(1));
}
