// Measures runs. Each step is derived and compiled once. Errors are measured at the end of a whole
// run, for each length of steps. Costs are measured on a few steps of one length, which all
// compiled steps repeat in turn.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

#include "elgen/bench.hpp"
#include "emit/interface/code_interface.hpp"

namespace elgen {
namespace {

/// In instructions. Compilers take minutes for longer functions.
constexpr std::size_t max_compiled_instructions = 20'000;

/// Runs with the same step and scalar of accelerations share compiled code.
using StepKey = std::pair<StepSpec, InnerScalar>;

StepKey step_key(const Design& design) { return {*design.step, design.inner}; }

/// The step in words: "`rk4` of order 4 with accelerations in float".
std::string name_of_step(const StepKey& key) {
  const auto& [step, inner] = key;
  return fmt::format("`{}` of order {}{}", step_method_row(step.method).name, step_order(step),
                     inner == InnerScalar::same ? "" : " with accelerations in float");
}

/// A compiled step, or why it is not compiled.
struct StepCode {
  StepLoops loops = {};
  std::string failure = {};
  bool is_measured = true;  ///< false: the step is not measured; a sentence in `refusals_` says why
  MeasuredCost single_cost = {};  ///< ns per step
  MeasuredCost pack_cost = {};
};

/// The sentences below the table: of a reference with this tolerance and uncertainty, whose two
/// runs differ by `distance`, and of the times of steps.
std::vector<std::string> table_sentences(const std::map<StepKey, StepCode>& codes, double tolerance,
                                         double distance, double uncertainty) {
  std::vector<std::string> all{fmt::format(
      "reference: Fehlberg's method of order 8 in long double, with tolerance {:g}; a run with "
      "{:g} differs by {:.1e}, so errors below {:.1e} are not measured",
      tolerance, 10 * tolerance, distance, uncertainty)};
  for (const auto& [key, code] : codes) {
    if (code.loops.one_state_loop == nullptr) continue;
    all.push_back(fmt::format("one step by {} takes {:.4g} ns, in packs {:.4g} ns",
                              name_of_step(key), code.single_cost.least, code.pack_cost.least));
  }
  return all;
}

/// E621 with this message.
Diagnostics run_option_error(std::string message) { return {{Code::E621, {}, std::move(message)}}; }

/// True if `length` divides `time` into 1 to 1e8 steps.
bool divides_run(double length, double time) {
  constexpr double most_steps = 1e8;  // 1e8 of the fastest steps take minutes
  const double count = time / length;
  return count >= 1 && count <= most_steps &&
         std::abs(count - std::round(count)) <= 1e-9 * count;  // the length is a rounded decimal
}

Result<StepLoops> compile_step_loops(const Products& products, const Limits& limits) {
  const auto& [model, scene] = *products.checked;
  const Result<EmittedFiles> files = emit(model, scene, *products.program, {});
  if (!files) return files.diagnostics;
  return compile_step_loops(*files, model, scene, *products.program, limits);
}

class RunBench {
 public:
  RunBench(const RunRequest& request, const BenchOptions& process)
      : request_(request), time_(request.duration), process_(process) {}

  Result<MeasuredTable> measure() {
    const Result<Machine> machine = this_machine(process_.limits);
    if (!machine) return machine.diagnostics;
    exact_ = derive_run({});
    if (!exact_.program) return exact_.diagnostics;
    const Result<CheckedModel> assembled = assemble_start(*exact_.checked, 0);
    if (!assembled) return assembled.diagnostics;
    exact_.checked = *assembled;
    if (Diagnostics wrong = compute_reference(); !wrong.empty()) return wrong;
    table_ = {.model = exact_.checked->scene.base_name,
              .subject = fmt::format("run of {:g} s", time_),
              .cost = "ns per run",
              .error = "errors at the end relative to the largest value of the run",
              .dimensions = {"method", "order", "step", "batch", "inner"},
              .machine = *machine};
    const std::vector<PlannedRun> plan = plan_runs(time_, request_.step_lengths);
    for (const PlannedRun& planned : plan) prepare_step(step_key(planned.design));
    process_.on_stage("run");
    process_.renew_time_limit();
    for (const PlannedRun& planned : plan) add_row(planned);
    process_.on_stage("time");
    process_.renew_time_limit();
    time_steps();
    table_.sentences = table_sentences(codes_, reference_.tolerance, distance_, uncertainty_);
    if (!exact_.checked->model.constraints.empty()) {
      table_.sentences.emplace_back("the cost includes a call of `projected` after every step");
    }
    table_.sentences.insert(table_.sentences.end(), refusals_.begin(), refusals_.end());
    return {{std::move(table_)}, exact_.diagnostics};
  }

 private:
  Products derive_run(const std::optional<StepSpec>& step, InnerScalar inner = InnerScalar::same) {
    process_.renew_time_limit();
    PipelineOptions options{
        .limits = process_.limits, .goals = {Goal::choose}, .on_stage = process_.on_stage};
    options.scene.purpose = purpose::time_run;
    options.scene.inner = inner;
    return derive_for_run(request_.inputs, options, step);
  }

  /// Computes the reference run and its uncertainty.
  Diagnostics compute_reference() {
    process_.on_stage("reference");
    Result<ReferenceRun> reference = run_reference(*exact_.checked, *exact_.program, time_);
    if (!reference) return reference.diagnostics;
    reference_ = std::move(*reference);
    distance_ = run_errors(reference_.rough_last, reference_, exact_.checked->model).worst;
    // If rounding errors dominate, both runs err by as much, and a part of it may be common.
    constexpr double safety = 4;
    uncertainty_ = std::max(safety * distance_, std::numeric_limits<double>::epsilon() / 2);
    return {};
  }

  /// Derives and compiles the step, unless this was done before.
  void prepare_step(const StepKey& key) {
    const auto [at, is_new] = codes_.try_emplace(key);
    if (is_new) at->second = compile_step(key);
  }

  /// The compiled step. If the method does not suit the system, or if the function is too long, the
  /// result has `is_measured` false, and `refusals_` gets a sentence.
  StepCode compile_step(const StepKey& key) {
    const auto& [step, inner] = key;
    Products products = derive_run(step, inner);
    if (!products.program) {
      const Diagnostic& error = *find_error(products.diagnostics);
      const bool is_for_others = error.code == Code::E622 || error.code == Code::E539;
      return is_for_others ? refuse_step(error.message) : StepCode{.failure = error.message};
    }
    keep_outputs({std::string(output_row(OutputKind::step).name),
                  std::string(output_row(OutputKind::projected).name)},
                 products);
    const Function& function =
        *std::ranges::find(products.program->functions, OutputKind::step, &Function::kind);
    const bool fits =
        literals_fit(products.checked->model, *products.program, ScalarKind::single_precision);
    if (inner != InnerScalar::same && !fits) {
      return refuse_step(
          "a number of the system does not fit float, so no accelerations are computed in float");
    }
    const std::size_t length = function.instructions.size();
    if (length > max_compiled_instructions || !is_returned_by_value(function)) {
      return refuse_step(
          fmt::format("{} has {} instructions and is not compiled", name_of_step(key), length));
    }
    process_.on_stage(fmt::format("compile {}", name_of_step(key)));
    Result<StepLoops> loops = compile_step_loops(products, process_.limits);
    if (!loops) return {.failure = find_error(loops.diagnostics)->message};
    return {.loops = std::move(*loops)};
  }

  StepCode refuse_step(const std::string& sentence) {
    if (std::ranges::find(refusals_, sentence) == refusals_.end()) refusals_.push_back(sentence);
    return {.is_measured = false};
  }

  void add_row(const PlannedRun& planned) {
    const StepCode& code = codes_.at(step_key(planned.design));
    if (!code.is_measured) return;
    TradeoffRow row{.values = planned.values, .design = planned.design};
    row.failure = code.failure.substr(0, code.failure.find('\n'));
    if (row.failure.empty()) measure_error(planned, code.loops, row);
    table_.rows.push_back(std::move(row));
    steps_.push_back(planned.steps);
  }

  void measure_error(const PlannedRun& planned, const StepLoops& loops, TradeoffRow& row) const {
    const CheckedModel& checked = *exact_.checked;
    const std::vector<double> last = run_to_end(checked, *exact_.program, loops, planned, time_);
    if (!std::ranges::all_of(last, [](double x) { return std::isfinite(x); })) {
      row.failure = "the numbers are no longer finite";
      return;
    }
    row.error = run_errors(last, reference_, checked.model);
    // The smallest possible error, for the Pareto front. An error is uncertain by `uncertainty_`,
    // and so is the error to which it is compared; hence the factor 2.
    row.error.least = std::max(row.error.worst - 2 * uncertainty_, 0.0);
    row.is_below_reference = row.error.worst <= uncertainty_;
    if (row.is_below_reference) row.error = {uncertainty_, uncertainty_, 0};
  }

  void time_steps() {
    std::vector<TimedWork> works;
    for (auto& [step, code] : codes_) {
      if (code.loops.one_state_loop == nullptr) continue;
      for (const bool in_packs : {false, true}) {
        works.push_back(
            make_step_work(*exact_.checked, *exact_.program, code.loops, in_packs, time_ / 1000));
        works.back().cost = in_packs ? &code.pack_cost : &code.single_cost;
      }
    }
    measure_costs(works);
    for (std::size_t i = 0; i < table_.rows.size(); ++i) {
      const Design& design = table_.rows[i].design;
      const StepCode& code = codes_.at(step_key(design));
      table_.rows[i].cost = design.in_packs ? code.pack_cost : code.single_cost;
      table_.rows[i].cost.least *= static_cast<double>(steps_[i]);
    }
  }

  const RunRequest& request_;
  double time_;
  const BenchOptions& process_;
  Products exact_ = {};  ///< derived without a step; the model has the assembled start
  ReferenceRun reference_ = {};
  double distance_ = 0;     ///< between both reference runs, relative
  double uncertainty_ = 0;  ///< relative error of the reference; at least u = 2^-53
  std::map<StepKey, StepCode> codes_ = {};
  TradeoffTable table_ = {};
  std::vector<std::size_t> steps_ = {};     ///< number of steps of a run, by row
  std::vector<std::string> refusals_ = {};  ///< "`verlet` is not for this system: ..."
};

}  // namespace

Result<MeasuredTable> measure_runs(const RunRequest& request, const BenchOptions& process) {
  const double time = request.duration;
  if (!(time > 0 && std::isfinite(time))) {
    return run_option_error(fmt::format("`--trajectory {}` is not a positive number", time));
  }
  for (const double length : request.step_lengths) {
    if (divides_run(length, time)) continue;
    return run_option_error(
        fmt::format("`--steps {}` does not divide {} s into whole steps", length, time));
  }
  return RunBench(request, process).measure();
}

}  // namespace elgen
