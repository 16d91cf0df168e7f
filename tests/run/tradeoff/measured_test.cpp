// Measuring: who is called when, and how often; how long it takes is not looked at.
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

using Figures = std::vector<std::vector<double>>;

/// The figures, with a running count appended by each measurement.
Figures counted(Figures figures, const Rounds& rounds) {
  double count = 0;
  by_turns(figures, rounds, [&count](std::size_t) { return ++count; });
  return figures;
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

TEST_CASE("all are measured once in each round, without time in the fewest") {
  CHECK(counted({{}, {}}, {.seconds = 0, .fewest = 2, .most = 9}) == Figures{{1, 3}, {2, 4}});
}

TEST_CASE("with time there are as many rounds as there may be") {
  CHECK(counted({{}}, {.seconds = 1e6, .fewest = 1, .most = 3}) == Figures{{1, 2, 3}});
}

TEST_CASE("what is there already counts") {
  CHECK(counted({{7}, {8}}, {.seconds = 0, .fewest = 2, .most = 2}) == Figures{{7, 1}, {8, 2}});
}

TEST_CASE("where nothing is measured no time passes") {
  CHECK(counted({}, {.seconds = 1e6, .fewest = 1, .most = 1'000'000'000'000}).empty());
}
