// Runs take turns, like designs, so that all meet the same machine.
#include "cli/runs.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "cli/process/progress.hpp"
#include "cli/process/resources.hpp"
#include "cli/shown_pipeline.hpp"

namespace elgen::cli {

namespace {

constexpr Rounds rounds_of_runs{.seconds = 3, .fewest = 3, .most = 101};

/// The products that runs by one program of `step`, or all that call accelerations, share.
struct RunSystem {
  Products products = {};
  CompiledHeaders headers = {};
};

/// The first one, of which there is one.
const Diagnostic& error_among(const Diagnostics& diagnostics) {
  return *std::ranges::find_if(diagnostics, [](const Diagnostic& diagnostic) {
    return code_row(diagnostic.code).severity == Severity::error;
  });
}

class RunBench {
 public:
  RunBench(const RunRequest& request, const Limits& limits) : request_(request), limits_(limits) {}

  Result<TradeoffTable> measure() {
    const Result<Machine> machine = this_machine(limits_);
    if (!machine) return machine.diagnostics;
    const Result<Trajectory> reference = run(reference_run(request_.time));
    if (!reference) return reference.diagnostics;
    const Products& exact = systems_.at(std::nullopt)->products;
    table_ = {.model = exact.checked->scene.base_name,
              .subject = fmt::format("{:g} s in time", request_.time),
              .cost = "ns per run",
              .error = "errors at the end relative to the largest value on the way",
              .dimensions = {"method", "step"},
              .machine = *machine};
    for (const PlannedRun& planned : planned_runs(request_.time)) add(planned, *reference);
    time_all();
    return {std::move(table_), exact.diagnostics};
  }

 private:
  Result<Trajectory> run(const SimulationOptions& options) {
    const Result<RunSystem>& system = system_for(step_of_run(options));
    if (!system) return system.diagnostics;
    const auto& [products, headers] = *system;
    return simulate(*products.checked, *products.program, headers.front().functions.get(), options);
  }

  /// All of them are compiled, so that times compare.
  const Result<RunSystem>& system_for(std::optional<StepMethod> step) {
    const auto [at, is_new] = systems_.try_emplace(step);
    if (is_new) at->second = made_for(step);
    return at->second;
  }

  Result<RunSystem> made_for(std::optional<StepMethod> step) {
    renew_time_limit(limits_);
    PipelineOptions options;
    options.limits = limits_;
    options.goals = {Goal::choose};
    Products products = derived_for_run(request_.path, request_.inputs, options, step);
    if (!products.program) return products.diagnostics;
    const Progress progress(request_.path);
    progress.stage("compile");
    Result<CompiledHeaders> headers = compiled_for_run(products, limits_);
    if (!headers) return headers.diagnostics;
    return RunSystem{std::move(products), std::move(*headers)};
  }

  static double cost(const Trajectory& trajectory) {
    return trajectory.nanoseconds * static_cast<double>(trajectory.steps);
  }

  /// A run that ends early has a row that says why; a method that is refused has none.
  void add(const PlannedRun& planned, const Trajectory& reference) {
    const Result<Trajectory> first = run(planned.options);
    if (!first && error_among(first.diagnostics).code == Code::E622) {
      refusals_.insert(error_among(first.diagnostics).message);
      return;
    }
    TradeoffRow row{.values = planned.values};
    if (first) {
      row.error = errors_of(*first, reference, systems_.at(std::nullopt)->products.checked->model);
      runs_.push_back(planned.options);
      costs_.push_back({cost(*first)});
    } else {
      const std::string& message = error_among(first.diagnostics).message;
      row.failure = message.substr(0, message.find('\n'));
    }
    table_.rows.push_back(std::move(row));
  }

  void time_all() {
    const Progress progress(request_.path);
    progress.stage("run");
    renew_time_limit(limits_);
    by_turns(costs_, rounds_of_runs, [this](std::size_t i) { return cost(*run(runs_[i])); });
    std::size_t done = 0;
    for (TradeoffRow& row : table_.rows) {
      if (row.failure.empty()) row.cost = spread_of(costs_[done++]);
    }
    table_.sentences.assign(refusals_.begin(), refusals_.end());
  }

  const RunRequest& request_;
  const Limits& limits_;
  std::map<std::optional<StepMethod>, Result<RunSystem>> systems_ = {};
  TradeoffTable table_ = {};
  std::vector<SimulationOptions> runs_ = {};     ///< of the rows that have not failed
  std::vector<std::vector<double>> costs_ = {};  ///< of each, in turn
  std::set<std::string> refusals_ = {};          ///< "`verlet` is not for this system: ..."
};

}  // namespace

Result<TradeoffTable> measured_runs(const RunRequest& request, const Limits& limits) {
  if (!(request.time > 0 && std::isfinite(request.time))) {
    return Diagnostic{
        Code::E621, {}, fmt::format("`--trajectory {}` is not a positive number", request.time)};
  }
  return RunBench(request, limits).measure();
}

}  // namespace elgen::cli
