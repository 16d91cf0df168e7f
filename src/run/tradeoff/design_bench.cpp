// Designs that are derived alike share a run of the pipeline, and those that are also compiled
// alike a library.
#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <utility>

#include "elgen/bench.hpp"
#include "elgen/wording.hpp"
#include "emit/interface/code_interface.hpp"

namespace elgen {
namespace {

/// The output that a table is about where none is named.
std::string default_output(const Scene& scene) {
  const auto is_usual = [](const OutputRequest& output) {
    return output.kind == OutputKind::inverse_dynamics;
  };
  const auto usual = std::ranges::find_if(scene.outputs, is_usual);
  return usual != scene.outputs.end() ? usual->name : scene.outputs.front().name;
}

/// Each design goes through its 1000 states in a turn: they fit a cache, in which their arrays do
/// not lie at the same places, as those of 1024 would.
constexpr std::size_t state_count = TradeoffSampling().count;

std::string first_line(const Diagnostics& diagnostics) {
  const Diagnostic& error = *find_error(diagnostics);
  std::string message = error.message.substr(0, error.message.find('\n'));
  if (message.ends_with(':')) message.pop_back();
  return fmt::format("{}: {}", code_row(error.code).name, message);
}

/// Designs of one library.
struct Workpiece {
  std::vector<std::size_t> designs = {};
  /// Of each, then of each in packs by one state per call; none where they could not be made.
  TimedFunctions functions = {};
};

class DesignBench {
 public:
  DesignBench(const DesignRequest& request, const BenchProcess& process)
      : request_(request), process_(process) {}

  Result<MeasuredTable> measure() {
    const Result<Machine> machine = this_machine(process_.limits);
    if (!machine) return machine.diagnostics;
    result_.table.machine = *machine;
    Result<OutputBase> base =
        output_base(request_.inputs, request_.output, request_.ranges, process_.limits);
    if (!base) return base.diagnostics;
    base_ = std::move(*base);
    Diagnostics wrong = contradictions(base_.base(), request_.choices.pinned);
    if (!wrong.empty()) return wrong;
    describe();
    const Products& exact = derived(exact_design);
    if (!exact.program) return exact.diagnostics;
    if (!is_returned(exact.program->functions.front())) return too_large();
    if (wrong = prepare(exact); !wrong.empty()) return wrong;
    for (auto& [key, workpiece] : workpieces()) make(std::move(workpiece));
    search_all(exact);
    time_all();
    result_.table.rows = std::move(rows_);
    return {std::move(result_), std::move(base.diagnostics)};
  }

 private:
  void describe() {
    result_.table.model = base_.checked.scene.base_name;
    result_.table.subject = base_.checked.scene.outputs.front().name;
    result_.table.cost = "ns per state";
    result_.table.call_cost = "ns per call";
    result_.table.error = "errors relative to the largest value of a field";
    result_.table.sentences = {
        fmt::format("the worst error is {} times the worst of {} states and a search from there",
                    search_margin, state_count)};
  }

  [[nodiscard]] Diagnostics too_large() const {
    return {{Code::E603,
             {},
             fmt::format("{} has more than {} entries, and is not measured",
                         in_backticks(result_.table.subject), largest_returned)}};
  }

  [[nodiscard]] std::string text_of(const Design& design) const {
    return scene_text(base_.base(), design, request_.inputs.model->path);
  }

  Products run(const Design& design, Goal goal) {
    process_.renew_time_limit();
    PipelineOptions options;
    options.limits = process_.limits;
    options.goals = {goal};
    const SourcePointer scene = make_kept_source("design.scene.toml", text_of(design));
    Products products = run_pipeline({request_.inputs.model, scene}, options);
    if (products.checked) keep_only(result_.table.subject, products);
    return products;
  }

  /// Runs the pipeline where no design before was derived alike.
  const Products& derived(const Design& design) {
    const Design derivation = derivation_of(design);
    const auto [at, is_new] = derived_.try_emplace(text_of(derivation));
    if (is_new) {
      process_.on_stage("derive");
      at->second = run(derivation, Goal::choose);
    }
    return at->second;
  }

  /// The designs, the states, and what is exact there.
  Diagnostics prepare(const Products& exact) {
    Result<TradeoffPlan> planned = plan(*exact.checked, *exact.program, request_.choices);
    if (!planned) return planned.diagnostics;
    process_.on_stage("states");
    Result<TradeoffStates> states = tradeoff_states(*exact.checked, *exact.program, {});
    if (!states) return states.diagnostics;
    states_ = std::move(*states);
    result_.table.dimensions = planned->dimensions;
    designs_ = std::move(planned->designs);
    // One by one, a state is a call.
    const auto in_packs = [](const PlannedDesign& each) { return each.design.in_packs; };
    if (std::ranges::none_of(designs_, in_packs)) {
      result_.table.cost = std::exchange(result_.table.call_cost, {});
    }
    for (const PlannedDesign& each : designs_) {
      rows_.push_back({.values = each.values, .design = each.design});
    }
    return {};
  }

  /// By what their designs have in common: those derived alike follow each other.
  [[nodiscard]] std::map<std::string, Workpiece> workpieces() const {
    std::map<std::string, Workpiece> pieces;
    for (std::size_t i = 0; i < designs_.size(); ++i) {
      const Design& design = designs_[i].design;
      const std::string key = text_of(derivation_of(design)) + design.trigonometry;
      pieces[key].designs.push_back(i);
    }
    return pieces;
  }

  void make(Workpiece piece) {
    const Design& first = designs_[piece.designs.front()].design;
    const Products& products = derived(first);
    if (!products.program) return fail(piece, first_line(products.diagnostics));
    process_.on_stage(fmt::format("compile {}", name_of(rows_[piece.designs.front()])));
    Result<TimedFunctions> made = compiled(piece, products);
    if (!made) {
      fail(piece, first_line(made.diagnostics));
      Diagnostics& all = result_.not_compiled;
      all.insert(all.end(), made.diagnostics.begin(), made.diagnostics.end());
      return;
    }
    piece.functions = std::move(*made);
    made_.push_back(std::move(piece));
  }

  void fail(const Workpiece& piece, const std::string& why) {
    for (const std::size_t i : piece.designs) rows_[i].failure = why;
  }

  Result<TimedFunctions> compiled(const Workpiece& piece, const Products& products) {
    TimingOptions timing{.states = states_.states, .limits = process_.limits};
    Scene scene = products.checked->scene;
    scene.emission = {};
    scene.numerics.scalars.clear();
    for (const std::size_t i : piece.designs) {
      const Design& design = designs_[i].design;
      timing.variants.push_back({design.scalar, design.in_packs});
      if (design.in_packs) scene.numerics = numerics_of(design, std::move(scene.numerics.scalars));
      scene.emission.batch = scene.emission.batch || design.in_packs;
    }
    for (const std::size_t i : piece.designs) {
      const Design& design = designs_[i].design;
      if (design.in_packs) timing.variants.push_back({design.scalar, true, true});
    }
    if (scene.numerics.scalars.empty()) scene.numerics.scalars = {timing.variants.front().scalar};
    const Model& model = products.checked->model;
    const Result<EmittedFiles> files = emit(model, scene, *products.program, {});
    if (!files) return files.diagnostics;
    return compile_timed(*files, model, scene, *products.program, timing);
  }

  /// The numerics of the design's own scene, for one more scalar.
  Numerics numerics_of(const Design& design, std::vector<ScalarKind> scalars) {
    Numerics numerics = run(design, Goal::check).checked->scene.numerics;
    scalars.push_back(design.scalar);
    numerics.scalars = std::move(scalars);
    return numerics;
  }

  /// No clock has a say in how accurate a design is.
  void search_all(const Products& exact) {
    for (const Workpiece& piece : made_) {
      for (std::size_t k = 0; k < piece.designs.size(); ++k) {
        TradeoffRow& row = rows_[piece.designs[k]];
        process_.on_stage(fmt::format("search {}", name_of(row)));
        process_.renew_time_limit();
        const TimedFunction& function = *piece.functions[k];
        const FoundErrors found =
            found_errors(*exact.checked, *exact.program, states_,
                         [&function](const auto& states) { return function.at(states); });
        row.error = {search_margin * found.worst, found.median};
      }
    }
  }

  void time_all() {
    process_.on_stage("time");
    process_.renew_time_limit();
    std::vector<TimedWork> works;
    const auto add = [&works](TimedFunction& function, Spread& cost) {
      works.push_back({[&function] { function.run(); }, state_count, &cost});
    };
    for (const Workpiece& piece : made_) {
      std::size_t calls = piece.designs.size();
      for (std::size_t k = 0; k < piece.designs.size(); ++k) {
        const std::size_t i = piece.designs[k];
        add(*piece.functions[k], rows_[i].cost);
        if (designs_[i].design.in_packs) add(*piece.functions[calls++], rows_[i].call_cost);
      }
    }
    find_costs(works);
    for (std::size_t i = 0; i < rows_.size(); ++i) {
      if (!designs_[i].design.in_packs) rows_[i].call_cost = rows_[i].cost;
    }
  }

  const DesignRequest& request_;
  const BenchProcess& process_;
  std::map<std::string, Products> derived_ = {};
  OutputBase base_ = {};
  std::vector<PlannedDesign> designs_ = {};
  std::vector<TradeoffRow> rows_ = {};  ///< of the designs
  TradeoffStates states_ = {};
  std::vector<Workpiece> made_ = {};
  MeasuredTable result_ = {};
};

}  // namespace

void keep_only(const std::string& output, Products& products) {
  const auto is_other = [&output](const auto& named) { return named.name != output; };
  std::erase_if(products.checked->scene.outputs, is_other);
  if (!products.program) return;
  Program& program = *products.program;
  std::erase_if(program.functions, is_other);
  std::erase_if(program.readable, is_other);
}

Result<OutputBase> output_base(const Inputs& inputs, const std::string& output,
                               const std::vector<SourcePointer>& ranges, const Limits& limits) {
  PipelineOptions options;
  options.limits = limits;
  options.goals = {Goal::check};
  Diagnostics found;
  std::string name = output;
  if (name.empty()) {
    const Products whole = run_pipeline(inputs, options);
    if (!whole.checked) return whole.diagnostics;
    found = whole.diagnostics;
    name = default_output(whole.checked->scene);
  }
  options.scene.outputs = {make_kept_source("command line", name)};
  options.scene.ranges = ranges;
  Products one = run_pipeline(inputs, options);
  if (!one.checked) return one.diagnostics;
  keep_only(name, one);
  if (one.checked->scene.outputs.empty()) {
    return Diagnostic{Code::E601, {}, in_backticks(name) + " is not one output"};
  }
  const std::vector<OpenFunction>& functions = one.checked->model.functions;
  if (!functions.empty()) {
    return Diagnostic{
        Code::E633, functions.front().span,
        in_backticks(functions.front().name) + " is left open, and designs need its values",
        "give it an expression in `[functions]` of a scene"};
  }
  OutputBase base{std::move(*one.checked), {}, ranges};
  if (inputs.scene != nullptr) base.scene = parse_scene(inputs.scene, limits).value;
  return {std::move(base), std::move(found)};
}

Result<MeasuredTable> measured_designs(const DesignRequest& request, const BenchProcess& process) {
  return DesignBench(request, process).measure();
}

}  // namespace elgen
