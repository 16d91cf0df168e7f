// Runs take turns, like designs, so that all meet the same machine.
#include "cli/runs.hpp"

#include <fmt/format.h>

#include <cmath>
#include <set>

#include "cli/compiled_run.hpp"
#include "cli/process/progress.hpp"
#include "cli/process/resources.hpp"

namespace elgen::cli {

namespace {

constexpr Rounds rounds_of_runs{.seconds = 3, .fewest = 3, .most = 101};

class RunBench {
 public:
  RunBench(const Products& products, const CompiledModel& compiled, TradeoffTable& table)
      : products_(products), compiled_(compiled), table_(table) {}

  Diagnostics measure(const RunRequest& request) {
    const Result<Trajectory> reference = run(reference_run(request.time));
    if (!reference) return reference.diagnostics;
    for (const PlannedRun& planned : planned_runs(request.time)) add(planned, *reference);
    by_turns(costs_, rounds_of_runs, [this](std::size_t i) { return cost(*run(runs_[i])); });
    std::size_t done = 0;
    for (TradeoffRow& row : table_.rows) {
      if (row.failure.empty()) row.cost = spread_of(costs_[done++]);
    }
    table_.sentences.assign(refusals_.begin(), refusals_.end());
    return {};
  }

 private:
  [[nodiscard]] Result<Trajectory> run(const SimulationOptions& options) const {
    return simulate(*products_.checked, *products_.program, compiled_, options);
  }

  static double cost(const Trajectory& trajectory) {
    return trajectory.nanoseconds * static_cast<double>(trajectory.steps);
  }

  /// A run that ends early has a row that says why; a method that is refused has none.
  void add(const PlannedRun& planned, const Trajectory& reference) {
    const Result<Trajectory> first = run(planned.options);
    if (!first && first.diagnostics.front().code == Code::E622) {
      refusals_.insert(first.diagnostics.front().message);
      return;
    }
    TradeoffRow row{.values = planned.values};
    if (first) {
      row.error = errors_of(*first, reference, products_.checked->model);
      runs_.push_back(planned.options);
      costs_.push_back({cost(*first)});
    } else {
      row.failure = first.diagnostics.front().message;
    }
    table_.rows.push_back(std::move(row));
  }

  const Products& products_;
  const CompiledModel& compiled_;
  TradeoffTable& table_;
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
  const Result<Machine> machine = this_machine(limits);
  if (!machine) return machine.diagnostics;
  PipelineOptions options;
  options.limits = limits;
  options.goals = {"choose"};
  const Products products = derived_for_run(request.path, request.inputs, options);
  if (!products.program) return products.diagnostics;
  const Progress progress(request.path);
  progress.stage("compile");
  const Result<CompiledHeaders> headers = compiled_for_run(products, limits);
  if (!headers) return headers.diagnostics;
  progress.stage("run");
  renew_time_limit(limits);
  TradeoffTable table{.model = products.checked->scene.base_name,
                      .subject = fmt::format("{:g} s in time", request.time),
                      .cost = "ns per run",
                      .error = "errors at the end relative to the largest value on the way",
                      .dimensions = {"method", "step"},
                      .machine = *machine};
  RunBench bench(products, *headers->front().functions, table);
  const Diagnostics wrong = bench.measure(request);
  if (!wrong.empty()) return wrong;
  return {std::move(table), products.diagnostics};
}

}  // namespace elgen::cli
