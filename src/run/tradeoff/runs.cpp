// Treats runs in time as designs: combines all methods, orders, step lengths, batches and scalars
// of accelerations, and makes the steps. The table of these designs is a work-precision diagram.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "elgen/tradeoff.hpp"
#include "run/steps/system.hpp"

namespace elgen {
namespace {

constexpr std::array<double, 3> default_step_counts{100, 1000, 10'000};
constexpr double full_turn = 6.283185307179586;

/// A single state makes so many steps that the cost of the call is negligible. For small models,
/// the states in packs and their results fit the fastest cache.
constexpr std::size_t steps_of_single_state = 200;
constexpr std::size_t states_in_packs = 256;
constexpr std::size_t steps_in_packs = 8;

/// |x - y|; for an angle that wraps, modulo a full turn.
double state_distance(double x, double y, bool wraps) {
  return wraps ? std::abs(std::remainder(x - y, full_turn)) : std::abs(x - y);
}

/// Repeats every number `count` times.
Numbers repeat(const Numbers& numbers, std::size_t count) {
  Numbers all;
  for (const double number : numbers) all.insert(all.end(), count, number);
  return all;
}

/// A run with steps of `h` seconds; `steps` of the result is still 0.
PlannedRun plan_run(const StepMethodRow& method, std::uint32_t order, double h, InnerScalar inner,
                    bool in_packs) {
  const std::string length = fmt::format("{:g} s", h);
  const StepSpec step = default_step(method.id, order == method.order ? 0 : order);
  return {
      {std::string(method.name), std::to_string(order), length, in_packs ? "packs" : "one",
       std::string(inner_scalar_row(inner).name)},
      {.in_packs = in_packs, .inner = inner, .step = step, .doc = "For steps of " + length + "."},
      0};
}

/// Adds runs of `steps` steps of `h` seconds, for single states and for packs, with accelerations
/// in double and, if the method calls accelerations, in float.
void add_runs(const StepMethodRow& method, std::uint32_t order, double h, std::size_t steps,
              std::vector<PlannedRun>& runs) {
  for (const InnerScalar inner : {InnerScalar::same, InnerScalar::single_precision}) {
    if (inner != InnerScalar::same && method.id == StepMethod::midpoint) continue;
    for (const bool in_packs : {false, true}) {
      runs.push_back(plan_run(method, order, h, inner, in_packs));
      runs.back().steps = steps;
    }
  }
}

}  // namespace

std::vector<PlannedRun> plan_runs(double time, const std::vector<double>& lengths) {
  std::vector<double> counts;
  for (const double length : lengths) counts.push_back(std::round(time / length));
  if (lengths.empty()) counts.assign(default_step_counts.begin(), default_step_counts.end());
  std::vector<PlannedRun> runs;
  for (const StepMethodRow& method : step_methods) {
    for (const std::uint32_t order : step_orders(method.order)) {
      for (const double steps : counts) {
        add_runs(method, order, time / steps, static_cast<std::size_t>(steps), runs);
      }
    }
  }
  return runs;
}

std::vector<double> run_to_end(const CheckedModel& checked, const Program& program,
                               const StepLoops& loops, const PlannedRun& run, double time) {
  SimulatedSystem system(checked, program, nullptr);
  const std::size_t size = system.position_count() + system.velocity_count();
  Numbers state = system.start_state();
  state.resize(size);
  state.resize(loops.entries);
  Numbers spare(loops.entries);
  const StepLoop loop = run.design.in_packs ? loops.pack_loop : loops.one_state_loop;
  const double h = time / static_cast<double>(run.steps);
  const std::size_t stride = !checked.scene.laws.empty() ? 1 : run.steps;
  for (std::size_t i = 0; i < run.steps; i += stride) {
    const double t = static_cast<double>(i) * h;
    const Numbers& u = system.update_inputs(state.data(), system.v_of(state), t);
    loop(1, stride, t, h, u.data(), state.data(), spare.data());
  }
  state.resize(size);
  return state;
}

TimedWork make_step_work(const CheckedModel& checked, const Program& program,
                         const StepLoops& loops, bool in_packs, double length) {
  SimulatedSystem system(checked, program, nullptr);
  Numbers start = system.start_state();
  const std::size_t count = in_packs ? states_in_packs : 1;
  const std::size_t steps = in_packs ? steps_in_packs : steps_of_single_state;
  const Numbers inputs = repeat(system.update_inputs(start.data(), system.v_of(start), 0), count);
  start.resize(system.position_count() + system.velocity_count());
  start.resize(loops.entries);
  const Numbers first = repeat(start, count);
  const StepLoop loop = in_packs ? loops.pack_loop : loops.one_state_loop;
  const auto work = [=, state = first, spare = first]() mutable {
    std::ranges::copy(first, state.begin());
    loop(count, steps, 0, length, inputs.data(), state.data(), spare.data());
  };
  return {work, count * steps, nullptr};
}

DesignErrors run_errors(const std::vector<double>& last, const ReferenceRun& reference,
                        const Model& model) {
  const std::size_t coordinates = model.coordinates.size();
  std::vector<double> errors;
  for (std::size_t i = 0; i < last.size(); ++i) {
    const bool wraps = i < coordinates && model.coordinates[i].wraps;
    const double error = state_distance(last[i], reference.last[i], wraps);
    errors.push_back(error == 0 ? 0 : error / reference.largest[i]);
  }
  std::sort(errors.begin(), errors.end());
  return {errors.back(), errors[errors.size() / 2]};
}

}  // namespace elgen
