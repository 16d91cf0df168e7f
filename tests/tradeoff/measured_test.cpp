// Measuring: who is called when; how long it takes is not looked at.
#include <catch2/catch.hpp>
#include <chrono>

#include "elgen/tradeoff.hpp"

using namespace elgen;

namespace {

void pass(std::chrono::microseconds time) {
  const auto end = std::chrono::steady_clock::now() + time;
  while (std::chrono::steady_clock::now() < end) {
  }
}

}  // namespace

TEST_CASE("alternatives take turns, nine rounds of them at least") {
  std::string calls;
  const auto work = [&calls](char name) {
    return [&calls, name] {
      calls += name;
      pass(std::chrono::microseconds(50));
    };
  };
  const std::vector<Spread> spreads = measured({work('a'), work('b')}, 0);
  REQUIRE(spreads.size() == 2);
  CHECK(calls ==
        "aabb"
        "abababababababab"
        "ab");
  for (const Spread& spread : spreads) {
    CHECK(spread.low >= 5e4);
    CHECK(spread.low <= spread.median);
    CHECK(spread.median <= spread.high);
  }
}

TEST_CASE("what is over before the clock moves is repeated") {
  std::size_t calls = 0;
  (void)measured({[&calls] { ++calls; }}, 0);
  CHECK(calls > 100);
}
