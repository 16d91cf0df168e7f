// Measures designs. Designs with the same derivation share a run of the pipeline; if they also have
// the same sines and inner scalar, they share a compiled library.
#include <fmt/ranges.h>

#include <algorithm>
#include <map>
#include <utility>

#include "base/reason.hpp"
#include "elgen/bench.hpp"
#include "elgen/syntax.hpp"
#include "elgen/wording.hpp"
#include "emit/interface/code_interface.hpp"

namespace elgen {
namespace {

/// The output that is measured if the command names none: inverse dynamics, or the first output.
std::string default_output(const Scene& scene) {
  const auto usual =
      std::ranges::find(scene.outputs, OutputKind::inverse_dynamics, &OutputRequest::kind);
  return usual != scene.outputs.end() ? usual->name : scene.outputs.front().name;
}

/// In each turn, every design evaluates all states. 3 * 336 = 1008 states fit a cache and fill
/// packs of 16. With 1024 states the arrays would be mapped to the same sets of the cache.
constexpr std::size_t sample_count = 3;
constexpr std::size_t states_of_sample = 336;

std::string first_error_line(const Diagnostics& diagnostics) {
  const Diagnostic& error = *find_error(diagnostics);
  std::string message = error.message.substr(0, error.message.find('\n'));
  if (message.ends_with(':')) message.pop_back();
  return fmt::format("{}: {}", code_row(error.code).name, message);
}

/// Designs that share a compiled library.
struct DesignLibrary {
  std::vector<TradeoffRow*> rows = {};
  /// A function for each row; then, for each row with packs, the function that is called with a
  /// single state. Empty if compilation failed.
  TimedFunctions functions = {};
};

/// Runs the pipeline and the compiler on designs of one output.
class DesignCompiler {
 public:
  DesignCompiler(const DesignRequest& request, const SingleOutputModel& base,
                 const BenchOptions& process)
      : request_(request), base_(base), process_(process) {}

  /// The scene of `design` as a text, used as a key. Two designs with the same derivation have the
  /// same design_key(derivation_key(design)).
  [[nodiscard]] std::string design_key(const Design& design) const {
    return scene_text(base_.design_source(), design, request_.inputs.model->path);
  }

  /// The pipeline's products for the design's derivation, memoised.
  const Products& derive_design(const Design& design) {
    const Design derivation = derivation_key(design);
    const auto [at, is_new] = derived_.try_emplace(design_key(derivation));
    if (is_new) {
      process_.on_stage("derive");
      at->second = run_design_pipeline(derivation, Goal::choose);
    }
    return at->second;
  }

  Result<TimedFunctions> compile_library(const DesignLibrary& piece, const Products& products,
                                         const std::vector<Arguments<double>>& states) {
    TimingOptions timing{.states = states, .limits = process_.limits};
    Scene scene = products.checked->scene;
    scene.emission = {};
    scene.numerics.scalars.clear();
    for (const TradeoffRow* const row : piece.rows) {
      const Design& design = row->design;
      timing.variants.push_back({design.scalar, design.in_packs});
      if (design.in_packs) scene.numerics = numerics_of(design, std::move(scene.numerics.scalars));
      scene.emission.has_batch_header = scene.emission.has_batch_header || design.in_packs;
    }
    for (const TradeoffRow* const row : piece.rows) {
      if (row->design.in_packs) timing.variants.push_back({row->design.scalar, true, true});
    }
    if (scene.numerics.scalars.empty()) scene.numerics.scalars = {timing.variants.front().scalar};
    const Design& common = piece.rows.front()->design;
    scene.numerics.inner = common.inner;
    scene.numerics.has_library_sines = common.trigonometry == library_sines;
    if (!common.trigonometry.empty())
      scene.numerics.trigonometry_error = numerics_of(common, {}).trigonometry_error;
    const Model& model = products.checked->model;
    const Result<EmittedFiles> files = emit(model, scene, *products.program, {});
    if (!files) return files.diagnostics;
    return compile_timed_functions(*files, model, scene, *products.program, timing);
  }

 private:
  Products run_design_pipeline(const Design& design, Goal goal) {
    process_.renew_time_limit();
    const SourcePointer scene = make_permanent_source("design.scene.toml", design_key(design));
    Products products = run_pipeline(
        {request_.inputs.model, scene},
        {.scene = {.over = request_.over}, .limits = process_.limits, .goals = {goal}});
    if (products.checked) keep_outputs({base_.checked.scene.outputs.front().name}, products);
    return products;
  }

  /// The numerics of the design's scene, for `scalars` followed by the design's scalar.
  Numerics numerics_of(const Design& design, std::vector<ScalarKind> scalars) {
    Numerics numerics = run_design_pipeline(design, Goal::check).checked->scene.numerics;
    scalars.push_back(design.scalar);
    numerics.scalars = std::move(scalars);
    return numerics;
  }

  const DesignRequest& request_;
  const SingleOutputModel& base_;
  const BenchOptions& process_;
  std::map<std::string, Products> derived_ = {};
};

TradeoffTable make_design_table(const Scene& scene, const Machine& machine) {
  return {.model = scene.base_name,
          .subject = scene.outputs.front().name,
          .cost = "ns per state",
          .call_cost = "ns per call",
          .error = "errors relative to the largest value of a field",
          .sentences = {fmt::format(
              "the worst error is {} times the worst of {} samples of {} "
              "states, each with a search from its worst states; its noise is the spread of the "
              "samples",
              search_margin, sample_count, states_of_sample)},
          .machine = machine};
}

class DesignBench {
 public:
  DesignBench(const DesignRequest& request, const SingleOutputModel& base,
              const BenchOptions& process, const Machine& machine)
      : request_(request),
        process_(process),
        runs_(request, base, process),
        table_(make_design_table(base.checked.scene, machine)) {}

  Result<MeasuredTable> measure() {
    const Products& exact = runs_.derive_design(exact_design);
    if (!exact.program) return exact.diagnostics;
    if (!is_returned_by_value(exact.program->functions.front())) {
      return Diagnostic{Reason::too_many_entries,
                        {},
                        fmt::format("{} has more than {} entries, so it is not measured",
                                    quote_text(table_.subject), max_returned_entries)};
    }
    if (Diagnostics wrong = prepare_measurement(exact); !wrong.empty()) return wrong;
    for (auto& [key, workpiece] : group_by_library()) build_library(std::move(workpiece));
    search_errors(exact);
    time_designs();
    return MeasuredTable{std::move(table_), std::move(compile_errors_)};
  }

 private:
  /// Plans the designs, draws the states, and computes the exact values at the states.
  Diagnostics prepare_measurement(const Products& exact) {
    Result<TradeoffPlan> planned = plan_designs(*exact.checked, *exact.program, request_.choices);
    if (!planned) return planned.diagnostics;
    Result<StateLog> log = StateLog();
    if (request_.log != nullptr) log = read_state_log(*request_.log, exact.checked->model);
    if (!log) return log.diagnostics;
    process_.on_stage("states");
    for (std::uint64_t seed = 1; seed <= sample_count; ++seed) {
      Result<TradeoffStates> sample = sample_tradeoff_states(
          *exact.checked, *exact.program, {states_of_sample, seed, *log, sample_count});
      if (!sample) return sample.diagnostics;
      states_.insert(states_.end(), sample->states.begin(), sample->states.end());
      samples_.push_back(std::move(*sample));
    }
    table_.dimensions = planned->dimensions;
    add_sentences(log->rows.size());
    for (const PlannedDesign& each : planned->designs) {
      table_.rows.push_back({.values = each.values, .design = each.design});
    }
    // Without packs, every call evaluates one state, so both costs are equal.
    const auto in_packs = [](const TradeoffRow& row) { return row.design.in_packs; };
    if (std::ranges::none_of(table_.rows, in_packs)) {
      table_.cost = std::exchange(table_.call_cost, {});
    }
    return {};
  }

  /// Says which states and parameters are not as in the ranges and the file.
  void add_sentences(std::size_t rows) {
    if (rows > 0) {
      table_.sentences.push_back(fmt::format("the states are {} of {} rows of {}, spread evenly",
                                             std::min(rows, states_.size()), rows,
                                             request_.log->path));
    }
    if (request_.over.empty()) return;
    table_.sentences.push_back(
        fmt::format("parameters vary over {}: {} draws with {} states each",
                    fmt::join(column_words(option_words(request_.over), &covered_text), ", "),
                    states_.size() / states_of_draw, states_of_draw));
  }

  /// The designs, grouped by library. Libraries with the same derivation follow each other.
  [[nodiscard]] std::map<std::string, DesignLibrary> group_by_library() {
    std::map<std::string, DesignLibrary> pieces;
    for (TradeoffRow& row : table_.rows) {
      const Design& design = row.design;
      std::string key = runs_.design_key(derivation_key(design)) + design.trigonometry;
      if (design.inner != InnerScalar::same) key += inner_scalar_row(design.inner).name;
      pieces[key].rows.push_back(&row);
    }
    return pieces;
  }

  void build_library(DesignLibrary piece) {
    const TradeoffRow& first = *piece.rows.front();
    const Products& products = runs_.derive_design(first.design);
    if (!products.program) return mark_failed(piece, first_error_line(products.diagnostics));
    process_.on_stage(fmt::format("compile {}", name_of(first)));
    Result<TimedFunctions> made = runs_.compile_library(piece, products, states_);
    if (!made) {
      mark_failed(piece, first_error_line(made.diagnostics));
      compile_errors_.insert(compile_errors_.end(), made.diagnostics.begin(),
                             made.diagnostics.end());
      return;
    }
    piece.functions = std::move(*made);
    libraries_.push_back(std::move(piece));
  }

  static void mark_failed(const DesignLibrary& piece, const std::string& why) {
    for (TradeoffRow* const row : piece.rows) row->failure = why;
  }

  /// Sets the errors of all designs. The search is separate from the timing, because errors do not
  /// depend on the timing.
  void search_errors(const Products& exact) {
    for (const auto& [rows, functions] : libraries_) {
      for (std::size_t k = 0; k < rows.size(); ++k) {
        process_.on_stage(fmt::format("search {}", name_of(*rows[k])));
        process_.renew_time_limit();
        rows[k]->error = errors_in_samples(exact, *functions[k]);
      }
    }
  }

  [[nodiscard]] DesignErrors errors_in_samples(const Products& exact,
                                               const TimedFunction& function) const {
    const auto values_at = [&function](const auto& states) { return function.values_at(states); };
    std::vector<FoundErrors> found;
    for (const TradeoffStates& sample : samples_) {
      found.push_back(find_errors(*exact.checked, *exact.program, sample, values_at));
    }
    return combine_errors(std::move(found));
  }

  void time_designs() {
    process_.on_stage("time");
    process_.renew_time_limit();
    std::vector<TimedWork> works;
    const auto add = [this, &works](TimedFunction& function, MeasuredCost& cost) {
      works.push_back({[&function] { function.run(); }, states_.size(), &cost});
    };
    for (const auto& [rows, functions] : libraries_) {
      std::size_t calls = rows.size();
      for (std::size_t k = 0; k < rows.size(); ++k) {
        add(*functions[k], rows[k]->cost);
        if (rows[k]->design.in_packs) add(*functions[calls++], rows[k]->call_cost);
      }
    }
    measure_costs(works);
    for (TradeoffRow& row : table_.rows) {
      if (!row.design.in_packs) row.call_cost = row.cost;
    }
  }

  const DesignRequest& request_;
  const BenchOptions& process_;
  DesignCompiler runs_;
  TradeoffTable table_;
  std::vector<TradeoffStates> samples_ = {};
  std::vector<Arguments<double>> states_ = {};  ///< of all samples
  std::vector<DesignLibrary> libraries_ = {};
  Diagnostics compile_errors_ = {};
};

}  // namespace

void keep_outputs(const std::vector<std::string>& outputs, Products& products) {
  const auto is_other = [&outputs](const auto& named) {
    return std::ranges::count(outputs, named.name) == 0;
  };
  std::erase_if(products.checked->scene.outputs, is_other);
  if (!products.program) return;
  Program& program = *products.program;
  std::erase_if(program.functions, is_other);
  std::erase_if(program.readable, is_other);
}

Result<SingleOutputModel> read_single_output_model(const DesignRequest& request,
                                                   const Limits& limits) {
  const PipelineSources& inputs = request.inputs;
  PipelineOptions options{.limits = limits, .goals = {Goal::check}};
  options.scene.over = request.over;
  Diagnostics found;
  std::string name = request.output;
  if (name.empty()) {
    const Products whole = run_pipeline(inputs, options);
    if (!whole.checked) return whole.diagnostics;
    found = whole.diagnostics;
    name = default_output(whole.checked->scene);
  }
  options.scene.outputs = {make_permanent_source("command line", name)};
  options.scene.ranges = request.ranges;
  Products one = run_pipeline(inputs, options);
  if (!one.checked) return one.diagnostics;
  keep_outputs({name}, one);
  if (one.checked->scene.outputs.empty()) {
    return Diagnostic{Code::E601, {}, quote_text(name) + " is not one output"};
  }
  const std::vector<OpenFunction>& functions = one.checked->model.functions;
  if (!functions.empty()) {
    return Diagnostic{
        Code::E633, functions.front().span,
        quote_text(functions.front().name) + " is left open, and designs need its values",
        "give it an expression in `[functions]` of a scene"};
  }
  SingleOutputModel base{std::move(*one.checked), {}, request.ranges};
  if (inputs.scene != nullptr) base.scene = parse_scene(inputs.scene, limits).value;
  return {std::move(base), std::move(found)};
}

Result<MeasuredTable> measure_designs(const DesignRequest& request, const BenchOptions& process) {
  const Result<Machine> machine = this_machine(process.limits);
  if (!machine) return machine.diagnostics;
  const Result<SingleOutputModel> base = read_single_output_model(request, process.limits);
  if (!base) return base.diagnostics;
  Diagnostics wrong = scene_conflicts(base->design_source(), request.choices.pinned);
  if (!wrong.empty()) return wrong;
  DesignRequest completed = request;
  if (find_key(base->design_source().scene, "numeric", "trigonometry") != nullptr) {
    completed.choices.more.emplace_back("trigonometry");  // as if the command named it
  }
  Result<MeasuredTable> measured = DesignBench(completed, *base, process, *machine).measure();
  if (measured) measured.diagnostics = base.diagnostics;
  return measured;
}

}  // namespace elgen
