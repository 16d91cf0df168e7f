// Measurements: the order and number of calls, but not the measured times.
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

TEST_CASE("alternatives take turns in at least ten rounds, after a call that is not measured") {
  std::string calls;
  const auto work = [&calls](char name) {
    return [&calls, name] {
      calls += name;
      pass(std::chrono::microseconds(50));
    };
  };
  std::vector<MeasuredCost> costs(2);
  measure_costs({{work('a'), 1, costs.data()}, {work('b'), 50, &costs.back()}}, 0);
  std::string rounds = "aabb";  // finds the number of calls in a timing
  for (int round = 0; round < 10; ++round) rounds += "aabb";
  CHECK(calls == rounds);
  CHECK(costs.front().least >= 5e4);
  CHECK(costs.back().least >= 1e3);
  CHECK(costs.back().least < 5e4);
  for (const MeasuredCost& cost : costs) CHECK(cost.noise >= 0);
}

TEST_CASE("a cost is the least time, and its noise comes from even and odd rounds") {
  // Calls 0 and 1 find the number of calls in a timing, calls 2 and 3 are round 0, and so on.
  std::size_t calls = 0;
  const auto work = [&calls] {
    const bool is_in_even_round = calls++ / 2 % 2 == 1;
    pass(std::chrono::microseconds(is_in_even_round ? 1000 : 4000));
  };
  MeasuredCost cost;
  measure_costs({{work, 1, &cost}}, 0);
  CHECK(calls == 22);
  CHECK(cost.least >= 1e6);
  CHECK(cost.least < 4e6);
  CHECK(cost.noise > 0);
}

TEST_CASE("work shorter than a clock tick is repeated") {
  std::size_t calls = 0;
  MeasuredCost cost;
  measure_costs({{[&calls] { ++calls; }, 1, &cost}}, 0);
  CHECK(calls > 100);
}

TEST_CASE("without work no time passes") {
  measure_costs({}, 1e6);
  SUCCEED();
}
