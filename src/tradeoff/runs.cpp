// Runs in time as designs: method by step. Together they are a work-precision diagram.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "elgen/tradeoff.hpp"
#include "simulate/steps/methods.hpp"

namespace elgen {
namespace {

constexpr std::array steps_of_a_run{100, 1000, 10'000};
constexpr std::array tolerances{1e-4, 1e-6, 1e-8, 1e-10};
constexpr double turn = 6.283185307179586;

/// |x - y|, across the jump of an angle.
double distance(double x, double y, bool wraps) {
  return wraps ? std::abs(std::remainder(x - y, turn)) : std::abs(x - y);
}

}  // namespace

std::vector<PlannedRun> planned_runs(double time) {
  std::vector<PlannedRun> runs;
  for (const MethodRow& method : method_table()) {
    const std::string name(method.name);
    if (method.step == StepKind::adapted) {
      for (const double tolerance : tolerances) {
        runs.push_back({{name, fmt::format("to {:g}", tolerance)},
                        {.method = name, .time = time, .tolerance = tolerance}});
      }
      continue;
    }
    for (const int count : steps_of_a_run) {
      const double step = time / count;
      runs.push_back(
          {{name, fmt::format("{:g} s", step)}, {.method = name, .time = time, .step = step}});
    }
  }
  return runs;
}

SimulationOptions reference_run(double time) {
  return {.is_reference = true, .time = time, .tolerance = 1e-12, .every = time / 200};
}

DesignErrors errors_of(const Trajectory& run, const Trajectory& reference, const Model& model) {
  const std::size_t coordinates = model.coordinates.size();
  std::vector<double> errors;
  for (std::size_t i = 0; i < coordinates + model.velocities.size(); ++i) {
    const std::size_t column = 1 + i;
    double scale = 0;
    for (const auto& row : reference.rows) scale = std::max(scale, std::abs(row[column]));
    const bool wraps = i < coordinates && model.coordinates[i].wrap;
    const double error = distance(run.last[column], reference.last[column], wraps);
    errors.push_back(error == 0 ? 0 : error / scale);
  }
  std::sort(errors.begin(), errors.end());
  return {errors.back(), errors[errors.size() / 2]};
}

}  // namespace elgen
