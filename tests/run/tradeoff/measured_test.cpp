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

TEST_CASE("alternatives take turns in at least nine rounds") {
  std::string calls;
  const auto work = [&calls](char name) {
    return [&calls, name] {
      calls += name;
      pass(std::chrono::microseconds(50));
    };
  };
  std::vector<Quartiles> spreads(2);
  measure_costs({{work('a'), 1, spreads.data()}, {work('b'), 50, &spreads.back()}}, 0);
  CHECK(calls ==
        "aabb"
        "abababababababab"
        "ab");
  CHECK(spreads.front().low >= 5e4);
  CHECK(spreads.back().low >= 1e3);
  CHECK(spreads.back().low < 5e4);
  for (const Quartiles& spread : spreads) {
    CHECK(spread.low <= spread.median);
    CHECK(spread.median <= spread.high);
  }
}

TEST_CASE("work shorter than a clock tick is repeated") {
  std::size_t calls = 0;
  Quartiles spread;
  measure_costs({{[&calls] { ++calls; }, 1, &spread}}, 0);
  CHECK(calls > 100);
}

TEST_CASE("without work no time passes") {
  measure_costs({}, 1e6);
  SUCCEED();
}
