// Errors of designs.
#include <catch2/catch.hpp>
#include <cmath>
#include <limits>

#include "elgen/tradeoff.hpp"

using namespace elgen;

namespace {

/// Three states of a field of two entries and one of one entry.
TradeoffStates three_states() {
  TradeoffStates states;
  states.states.resize(3);
  states.field_sizes = {2, 1};
  for (const double value : {1.0, 2.0, -4.0, 0.0, 0.0, 1.0, 10.0, 20.0, 30.0}) {
    states.exact.push_back({value, 0});
  }
  return states;
}

}  // namespace

TEST_CASE("errors are relative to the largest magnitude of their field, the worst of each state") {
  const DesignErrors errors = errors_of({1, 2, -4.4, 0.2, 0, 1, 10, 20.3, 30}, three_states());
  CHECK(errors.worst == Approx(0.1));
  CHECK(errors.median == Approx(0.05));
}

TEST_CASE("digits beyond those of double count") {
  TradeoffStates states = three_states();
  states.exact[0].low = 1e-22;
  CHECK(errors_of({1, 2, -4, 0, 0, 1, 10, 20, 30}, states).worst == Approx(0.25e-22));
}

TEST_CASE("what is no number, or should be 0, is infinitely wrong") {
  TradeoffStates states = three_states();
  const double nan = std::numeric_limits<double>::quiet_NaN();
  CHECK(std::isinf(errors_of({1, nan, -4, 0, 0, 1, 10, 20, 30}, states).worst));
  for (std::size_t i = 6; i < 9; ++i) states.exact[i] = {0, 0};
  CHECK(std::isinf(errors_of({1, 2, -4, 0, 0, 1, 0, 1e-30, 0}, states).worst));
  CHECK(errors_of({1, 2, -4, 0, 0, 1, 0, 0, 0}, states).worst == 0);
}
