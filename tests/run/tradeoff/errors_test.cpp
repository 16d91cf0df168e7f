// Errors of designs. Plans, final states and final errors of runs with constant steps.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <limits>

#include "elgen/tradeoff.hpp"
#include "run/tradeoff/derived.hpp"

using namespace elgen;
using namespace elgen::test;

namespace {

/// Three states; the first field has two entries, the second field has one entry.
TradeoffStates three_states() {
  TradeoffStates states;
  states.states.resize(3);
  states.field_sizes = {2, 1};
  states.exact = {{{1}, {0}, {10}}, {{2}, {0}, {20}}, {{-4}, {1}, {30}}};
  return states;
}

/// A reference run that ends at `q` and `v`. The largest |q| and |v| during the run are 4 and 10.
ReferenceRun ending(double q, double v) { return {.last = {q, v}, .largest = {4, 10}}; }

Model one_angle(bool wraps) {
  Model model;
  append_coordinate(model, {.name = "q", .identifier = "q", .wraps = wraps});
  return model;
}

}  // namespace

TEST_CASE("an error is the worst of all fields, relative to the largest magnitude of its field") {
  const std::vector<double> errors =
      state_errors({1, 2, -4.4, 0.2, 0, 1, 10, 20.3, 30}, three_states());
  REQUIRE(errors.size() == 3);
  CHECK(errors[0] == Approx(0.05));
  CHECK(errors[1] == Approx(0.01));
  CHECK(errors[2] == Approx(0.1));
}

TEST_CASE("digits beyond double count") {
  TradeoffStates states = three_states();
  states.exact[0][0].low = 1e-22;
  CHECK(state_errors({1, 2, -4, 0, 0, 1, 10, 20, 30}, states)[0] == Approx(0.25e-22));
}

TEST_CASE("an error is relative to the states with the same parameters") {
  TradeoffStates states = three_states();
  for (Arguments<double>& state : states.states) state.parameters = {1};
  states.states[2].parameters = {2};
  const std::vector<double> errors = state_errors({1.2, 2, -4.4, 0, 0, 1, 10, 20, 33}, states);
  CHECK(errors[0] == Approx(0.1));
  CHECK(errors[1] == 0);
  CHECK(errors[2] == Approx(0.1));
}

TEST_CASE("NaN, or a non-zero value instead of 0, has an infinite error") {
  TradeoffStates states = three_states();
  const double nan = std::numeric_limits<double>::quiet_NaN();
  CHECK(std::isinf(state_errors({1, nan, -4, 0, 0, 1, 10, 20, 30}, states)[1]));
  for (std::vector<TwoDoubleNumber>& exact : states.exact) exact[2] = {0, 0};
  CHECK(std::isinf(state_errors({1, 2, -4, 0, 0, 1, 0, 1e-30, 0}, states)[1]));
  CHECK(state_errors({1, 2, -4, 0, 0, 1, 0, 0, 0}, states)[1] == 0);
}

TEST_CASE(
    "worst and least of three samples are the largest and smallest error, each with a margin") {
  const DesignErrors errors =
      combine_errors({{3e-7, 2e-8, {}}, {2e-7, 1e-8, {}}, {4e-7, 3e-8, {}}});
  CHECK(errors.worst == Approx(1.5 * 4e-7));
  CHECK(errors.least == Approx(1.5 * 2e-7));
  CHECK(errors.median == 2e-8);
}

TEST_CASE("methods, orders and scalars are planned with three step sizes, singly and in packs") {
  const std::vector<PlannedRun> runs = plan_runs(10);
  CHECK(runs.size() == (2 * (1 + 3) + 3) * 3 * 2);
  const auto named = [&](const std::vector<std::string>& values) {
    const auto found = std::ranges::find(runs, values, &PlannedRun::values);
    REQUIRE(found != runs.end());
    return *found;
  };
  const PlannedRun rk4 = named({"rk4", "4", "0.01 s", "one", "double"});
  CHECK(rk4.steps == 1000);
  CHECK(rk4.design == Design{.step = default_step(StepMethod::rk4), .doc = "For steps of 0.01 s."});
  const PlannedRun verlet = named({"verlet", "8", "0.1 s", "packs", "float"});
  CHECK(verlet.steps == 100);
  CHECK(verlet.design.in_packs);
  CHECK(verlet.design.inner == InnerScalar::single_precision);
  CHECK(verlet.design.step == default_step(StepMethod::verlet, 8));
}

TEST_CASE("runs are planned with the requested step sizes") {
  const std::vector<PlannedRun> runs = plan_runs(0.3, {0.1, 1e-3});
  CHECK(runs.size() == (2 * (1 + 3) + 3) * 2 * 2);
  CHECK(runs[0].values == std::vector<std::string>{"rk4", "4", "0.1 s", "one", "double"});
  CHECK(runs[0].steps == 3);
  CHECK(runs[4].values == std::vector<std::string>{"rk4", "4", "0.001 s", "one", "double"});
  CHECK(runs[4].steps == 300);
  const auto is_mixed_midpoint = [](const PlannedRun& run) {
    return run.values.front() == "midpoint" && run.design.inner != InnerScalar::same;
  };
  CHECK(std::ranges::none_of(runs, is_mixed_midpoint));
}

TEST_CASE("final errors are relative to the largest magnitude of each number during the run") {
  const DesignErrors errors = run_errors({1.4, 5.1}, ending(1, 5), one_angle(false));
  CHECK(errors.worst == Approx(0.1));
  CHECK(errors.median == Approx(0.1));
  CHECK(run_errors({1, 5}, ending(1, 5), one_angle(false)).worst == 0);
}

TEST_CASE("wrapped angles on both sides of the jump are close") {
  CHECK(run_errors({3.1, 5}, ending(-3.1, 5), one_angle(true)).worst < 0.03);
  CHECK(run_errors({3.1, 5}, ending(-3.1, 5), one_angle(false)).worst > 1);
}

TEST_CASE("loops of steps go from the start to the ends of runs") {
  // x'' = u - t by two steps of Euler's method, u = 0.
  const Products products = derived(model_text("mass", R"toml([[coordinate]]
name = "x"
start = { value = 1, rate = 2 }
[energy]
T = "1/2*dot(x)^2"
V = "t*x"
[[input]]
name = "u"
on = "x"
)toml"),
                                    "forward_dynamics");
  const StepLoop advance = [](std::size_t count, std::size_t steps, double t, double h,
                              const double* u, double* state, double*) {
    for (std::size_t k = 0; k < steps; ++k) {
      for (std::size_t i = 0; i < count; ++i) {
        state[i] += h * state[count + i];
        state[count + i] += h * (u[i] - t - static_cast<double>(k) * h);
      }
    }
  };
  const StepLoops loops{.one_state_loop = advance, .pack_loop = advance, .entries = 3};
  const CheckedModel& checked = *products.checked;
  const PlannedRun run{{}, {}, 2};
  // x = 1 + 2, v = 2 + 0; then x = 3 + 2, v = 2 - 1.
  CHECK(run_to_end(checked, *products.program, loops, run, 2) == std::vector<double>{5, 1});
  const TimedWork packs = make_step_work(checked, *products.program, loops, true, 0.01);
  packs.run();
  CHECK(packs.parts == 256 * 8);
}
