// Shards joined are the whole, and every field has its turn among the states that are visited.
#include <algorithm>
#include <catch2/catch.hpp>

#include "elgen/screening.hpp"

using namespace elgen;

namespace {

ScreenedStates states_of(std::vector<std::vector<ScreenedFigure>> worst) {
  return {ScalarKind::double_precision, 5000, std::move(worst)};
}

bool is_among(const std::vector<std::uint64_t>& states, std::uint64_t state) {
  return std::find(states.begin(), states.end(), state) != states.end();
}

}  // namespace

TEST_CASE("the lists of shards become one") {
  const Screening all = joined(
      {{states_of({{{1, 5.0}, {3, 2.0}}, {}})}, {states_of({{{2, 4.0}, {0, 2.0}}, {{4, 1.0}}})}});
  REQUIRE(all.size() == 1);
  CHECK(all.front().states == 10'000);
  CHECK(all.front().worst[0] ==
        std::vector<ScreenedFigure>{{1, 5.0}, {2, 4.0}, {0, 2.0}, {3, 2.0}});
  CHECK(all.front().worst[1] == std::vector<ScreenedFigure>{{4, 1.0}});
}

TEST_CASE("the first states are visited, and the worst of every figure in turn") {
  std::vector<std::vector<ScreenedFigure>> worst(2);
  for (std::uint64_t i = 0; i < 1000; ++i) {
    worst[0].push_back({1000 + i, 1e9});  // one field is bad everywhere
    worst[1].push_back({3000 + i, 2.0});
  }
  const std::vector<std::uint64_t> states = states_to_visit(states_of(worst));
  CHECK(states.size() == visits_after_screening);
  CHECK(std::is_sorted(states.begin(), states.end()));
  CHECK(is_among(states, 63));
  CHECK(is_among(states, 1000 + 467));
  CHECK(is_among(states, 3000 + 467));
  CHECK_FALSE(is_among(states, 3000 + 468));
}

TEST_CASE("few states are all visited") {
  const ScreenedStates few{ScalarKind::single_precision, 3, {{{2, 1.0}, {1, 0.0}, {0, 0.0}}}};
  CHECK(states_to_visit(few) == std::vector<std::uint64_t>{0, 1, 2});
}
