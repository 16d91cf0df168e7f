// Interval arithmetic that never loses a value.
#include "drop/enclosure.hpp"

#include <cln/float.h>

#include <catch2/catch.hpp>

using namespace elgen;
using cln::cl_RA;

namespace {

bool is(const Enclosure& x, const cl_RA& low, const cl_RA& high) {
  return x.low == low && x.high == high;
}

}  // namespace

TEST_CASE("sums and products of every sign") {
  CHECK(is(sum({-1, 2}, {3, 4}), 2, 6));
  CHECK(is(product({1, 2}, {3, 4}), 3, 8));
  CHECK(is(product({-1, 2}, {3, 4}), -4, 8));
  CHECK(is(product({-3, -2}, {-5, 7}), -21, 15));
  CHECK(magnitude({-3, 2}) == 3);
}

TEST_CASE("powers") {
  CHECK(is(*power({-3, 2}, 2), 0, 9));
  CHECK(is(*power({-3, -2}, 2), 4, 9));
  CHECK(is(*power({-3, 2}, 3), -27, 8));
  CHECK(is(*power({2, 4}, -1), cl_RA(1) / 4, cl_RA(1) / 2));
  CHECK(is(*power({-4, -2}, -1), cl_RA(-1) / 2, cl_RA(-1) / 4));
  CHECK(is(*power({-4, -2}, -2), cl_RA(1) / 16, cl_RA(1) / 4));
  CHECK(is(*power({-1, 1}, 0), 1, 1));
  CHECK_FALSE(power({-1, 1}, -1));
  CHECK_FALSE(power({0, 1}, -2));
}

TEST_CASE("roots are enclosed") {
  CHECK(is(square_root({cl_RA(1) / 4, 9}), cl_RA(1) / 2, 3));
  CHECK(is(square_root({-1, 4}), 0, 2));
  const Enclosure root = square_root({2, 2});
  CHECK(root.low * root.low < 2);
  CHECK(root.high * root.high > 2);
  CHECK(root.high - root.low < cl_RA(1) / 1000000);
}

TEST_CASE("numbers that are not rational are widened") {
  CHECK(is(enclosure_of(cl_RA(-2) / 3), cl_RA(-2) / 3, cl_RA(-2) / 3));
  const cln::cl_R root = cln::sqrt(cln::cl_float(2, cln::float_format(100)));
  const Enclosure about = enclosure_of(-root);
  CHECK(about.low < about.high);
  CHECK(about.low * about.low > 2);
  CHECK(about.high * about.high < 2);
  CHECK(is(enclosure_of(-1, 2), -1, 2));
}
