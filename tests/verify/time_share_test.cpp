// How many states fit, with times that are given.
#include "verify/states/time_share.hpp"

#include <catch2/catch.hpp>

using namespace elgen;

namespace {

/// States of these lengths, each with something to compare.
std::size_t visited(double share, const std::vector<double>& lengths) {
  TimeShare time(share);
  double now = 0;
  std::size_t states = 0;
  while (states < lengths.size() && time.fits_another(states)) {
    now += lengths[states++];
    time.add_state(now);
  }
  return states;
}

}  // namespace

TEST_CASE("as many states as fit, judged by the slowest") {
  CHECK(visited(10, {1, 1, 1, 1}) == 4);
  CHECK(visited(10, {3, 3, 3, 3}) == 3);
  CHECK(visited(10, {1, 4.5, 1, 1, 1}) == 3);
}

TEST_CASE("two states at least, one where it is longer than the share") {
  CHECK(visited(10, {9, 9, 9}) == 2);
  CHECK(visited(10, {11, 1, 1}) == 1);
  CHECK(visited(0, {1, 1, 1}) == 1);
}

TEST_CASE("states without anything to compare take time and do not count") {
  TimeShare time(10);
  time.add_state(20);
  CHECK(time.fits_another(0));
  CHECK_FALSE(time.fits_another(1));
}
