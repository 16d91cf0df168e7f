// Errors of designs, and runs as designs.
#include <algorithm>
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

Trajectory ending(double q, double v) {
  Trajectory trajectory;
  trajectory.rows = {{0, 4, 1}, {1, -2, 10}};
  trajectory.last = {2, q, v};
  return trajectory;
}

Model one_angle(bool wraps) {
  Model model;
  append_coordinate(model, {.name = "q", .identifier = "q", .wrap = wraps});
  return model;
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

TEST_CASE("every method is planned with steps of its kind") {
  const std::vector<PlannedRun> runs = planned_runs(10);
  const auto named = [&](const std::vector<std::string>& values) {
    const auto found = std::ranges::find(runs, values, &PlannedRun::values);
    REQUIRE(found != runs.end());
    return found->options;
  };
  CHECK(named({"rk4", "0.01 s"}).step == 0.01);
  CHECK_FALSE(named({"rk4", "0.01 s"}).tolerance);
  CHECK(named({"dopri5", "to 1e-06"}).tolerance == 1e-6);
  CHECK(named({"dopri5", "to 1e-06"}).time == 10);
  CHECK(reference_run(10).every == 0.05);
}

TEST_CASE("errors at the end are relative to the largest magnitude of each number on the way") {
  const DesignErrors errors = errors_of(ending(1.4, 5.1), ending(1, 5), one_angle(false));
  CHECK(errors.worst == Approx(0.1));
  CHECK(errors.median == Approx(0.1));
  CHECK(errors_of(ending(1, 5), ending(1, 5), one_angle(false)).worst == 0);
}

TEST_CASE("angles that wrap are near each other across the jump") {
  CHECK(errors_of(ending(3.1, 5), ending(-3.1, 5), one_angle(true)).worst < 0.03);
  CHECK(errors_of(ending(3.1, 5), ending(-3.1, 5), one_angle(false)).worst > 1);
}
