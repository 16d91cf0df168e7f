// Turns: who is measured when, and how often.
#include <catch2/catch.hpp>

#include "elgen/tradeoff.hpp"

using namespace elgen;

namespace {

using Figures = std::vector<std::vector<double>>;

/// What is appended to `figures` by counting.
Figures counted(Figures figures, const Rounds& rounds) {
  double count = 0;
  by_turns(figures, rounds, [&count](std::size_t) { return ++count; });
  return figures;
}

}  // namespace

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
