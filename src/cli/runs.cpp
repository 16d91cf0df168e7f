// Each step is derived and compiled once: by it runs of all lengths of steps go to their ends, for
// the errors, and some steps of one length, by turns, for the times.
#include "cli/runs.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <map>
#include <utility>

#include "cli/designs.hpp"
#include "cli/process/progress.hpp"
#include "cli/process/resources.hpp"
#include "cli/shown_pipeline.hpp"
#include "emit/interface/code_interface.hpp"

namespace elgen::cli {

namespace {

constexpr double seconds_of_steps = 1.5;

/// Compilers take minutes for more.
constexpr std::size_t longest_step = 20'000;

/// The first one, of which there is one.
const Diagnostic& error_among(const Diagnostics& diagnostics) {
  return *std::ranges::find_if(diagnostics, [](const Diagnostic& diagnostic) {
    return code_row(diagnostic.code).severity == Severity::error;
  });
}

/// "midpoint of order 8"
std::string name_of_step(const ChosenStep& step) {
  const StepMethodRow& method = step_methods[static_cast<std::size_t>(step.method)];
  return fmt::format("`{}` of order {}", method.name,
                     step.composed_order > 0 ? step.composed_order : method.order);
}

/// A step that is compiled, or why it is not.
struct StepCode {
  StepLoops loops = {};
  std::string failure = {};
  bool has_rows = true;  ///< one that is refused has none
  Spread one = {};       ///< ns of a step
  Spread in_packs = {};
};

class RunBench {
 public:
  RunBench(const RunRequest& request, const Limits& limits) : request_(request), limits_(limits) {}

  Result<TradeoffTable> measure() {
    const Result<Machine> machine = this_machine(limits_);
    if (!machine) return machine.diagnostics;
    exact_ = derived({});
    if (!exact_.program) return exact_.diagnostics;
    const Result<CheckedModel> assembled = assembled_model(*exact_.checked, 0);
    if (!assembled) return assembled.diagnostics;
    exact_.checked = *assembled;
    if (Diagnostics wrong = refer(); !wrong.empty()) return wrong;
    table_ = {.model = exact_.checked->scene.base_name,
              .subject = fmt::format("{:g} s in time", request_.time),
              .cost = "ns per run",
              .error = "errors at the end relative to the largest value on the way",
              .dimensions = {"method", "order", "step", "batch"},
              .machine = *machine};
    const std::vector<PlannedRun> plan = planned_runs(request_.time);
    for (const PlannedRun& planned : plan) make(*planned.design.step);
    const Progress progress(request_.path);
    progress.stage("run");
    renew_time_limit(limits_);
    for (const PlannedRun& planned : plan) add(planned);
    progress.stage("time");
    renew_time_limit(limits_);
    time_all();
    tell();
    return {std::move(table_), exact_.diagnostics};
  }

 private:
  Products derived(const std::optional<ChosenStep>& step) {
    renew_time_limit(limits_);
    PipelineOptions options;
    options.limits = limits_;
    options.goals = {Goal::choose};
    return derived_for_run(request_.path, request_.inputs, options, step);
  }

  /// The run that errors are measured from.
  Diagnostics refer() {
    const Progress progress(request_.path);
    progress.stage("reference");
    Result<ReferenceRun> reference = reference_run(*exact_.checked, *exact_.program, request_.time);
    if (!reference) return reference.diagnostics;
    reference_ = std::move(*reference);
    const double distance = errors_of(reference_.rougher, reference_, exact_.checked->model).worst;
    bar_ = std::max(distance, std::numeric_limits<double>::epsilon() / 2);
    return {};
  }

  /// Once for all runs by the same step.
  void make(const ChosenStep& step) {
    const auto [at, is_new] = codes_.try_emplace(step);
    if (is_new) at->second = made(step);
  }

  /// A method that is not for the system, and a step that is too long, are told of in a sentence.
  StepCode made(const ChosenStep& step) {
    Products products = derived(step);
    if (!products.program) {
      const Diagnostic& error = error_among(products.diagnostics);
      const bool is_for_others = error.code == Code::E622 || error.code == Code::E539;
      return is_for_others ? refused(error.message) : StepCode{.failure = error.message};
    }
    keep_only(std::string(output_row(OutputKind::step).name), products);
    const Function& function = products.program->functions.front();
    const std::size_t length = function.instructions.size();
    if (length > longest_step || !is_returned(function)) {
      return refused(fmt::format("{} is {} instructions long, and is not compiled",
                                 name_of_step(step), length));
    }
    const Progress progress(request_.path);
    progress.stage(fmt::format("compile {}", name_of_step(step)));
    Result<StepLoops> loops = compiled(products);
    if (!loops) return {.failure = error_among(loops.diagnostics).message};
    return {.loops = std::move(*loops)};
  }

  StepCode refused(const std::string& sentence) {
    if (std::ranges::find(refusals_, sentence) == refusals_.end()) refusals_.push_back(sentence);
    return {.has_rows = false};
  }

  [[nodiscard]] Result<StepLoops> compiled(const Products& products) const {
    const auto& [model, scene] = *products.checked;
    Scene plain = scene;
    plain.emission = {.name_space = scene.emission.name_space, .batch = true, .page = false};
    plain.numerics = {};
    const Result<EmittedFiles> files = emit(model, plain, *products.program, {});
    if (!files) return files.diagnostics;
    return compile_steps(*files, model, plain, *products.program, limits_);
  }

  void add(const PlannedRun& planned) {
    const StepCode& code = codes_.at(*planned.design.step);
    if (!code.has_rows) return;
    TradeoffRow row{.values = planned.values, .design = planned.design};
    row.failure = code.failure.substr(0, code.failure.find('\n'));
    if (row.failure.empty()) judge(planned, code.loops, row);
    table_.rows.push_back(std::move(row));
    steps_.push_back(planned.steps);
  }

  void judge(const PlannedRun& planned, const StepLoops& loops, TradeoffRow& row) const {
    const CheckedModel& checked = *exact_.checked;
    const std::vector<double> last =
        end_of_run(checked, *exact_.program, loops, planned, request_.time);
    if (!std::ranges::all_of(last, [](double x) { return std::isfinite(x); })) {
      row.failure = "the numbers are no longer finite";
      return;
    }
    row.error = errors_of(last, reference_, checked.model);
    row.is_below_reference = row.error.worst <= bar_;
    if (row.is_below_reference) row.error = {bar_, bar_};
  }

  void time_all() {
    std::vector<std::function<void()>> alternatives;
    std::vector<std::pair<Spread*, double>> spreads;
    for (auto& [step, code] : codes_) {
      if (code.loops.one == nullptr) continue;
      for (const bool in_packs : {false, true}) {
        const TimedSteps timed = timed_steps(*exact_.checked, *exact_.program, code.loops, in_packs,
                                             request_.time / 1000);
        alternatives.push_back(timed.work);
        spreads.emplace_back(in_packs ? &code.in_packs : &code.one,
                             static_cast<double>(timed.count));
      }
    }
    const std::vector<Spread> costs = measured(alternatives, seconds_of_steps);
    for (std::size_t i = 0; i < costs.size(); ++i) {
      *spreads[i].first = scaled(costs[i], 1 / spreads[i].second);
    }
    for (std::size_t i = 0; i < table_.rows.size(); ++i) {
      const Design& design = table_.rows[i].design;
      const StepCode& code = codes_.at(*design.step);
      table_.rows[i].cost =
          scaled(design.in_packs ? code.in_packs : code.one, static_cast<double>(steps_[i]));
    }
  }

  static Spread scaled(const Spread& spread, double factor) {
    return {spread.median * factor, spread.low * factor, spread.high * factor};
  }

  void tell() {
    table_.sentences.push_back(fmt::format(
        "reference: Fehlberg's method of order 8 to 1e-15 in long double and to 1e-12 in "
        "double, which differ by {:.1e}",
        bar_));
    for (const auto& [step, code] : codes_) {
      if (code.loops.one == nullptr) continue;
      table_.sentences.push_back(fmt::format("a step by {} takes {:.4g} ns, in packs {:.4g}",
                                             name_of_step(step), code.one.median,
                                             code.in_packs.median));
    }
    table_.sentences.insert(table_.sentences.end(), refusals_.begin(), refusals_.end());
  }

  const RunRequest& request_;
  const Limits& limits_;
  Products exact_ = {};  ///< the equations, and where they start
  ReferenceRun reference_ = {};
  double bar_ = 0;  ///< what the reference is known to, in errors; it is rounded to double
  std::map<ChosenStep, StepCode> codes_ = {};
  TradeoffTable table_ = {};
  std::vector<std::size_t> steps_ = {};     ///< of each row
  std::vector<std::string> refusals_ = {};  ///< "`verlet` is not for this system: ..."
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
