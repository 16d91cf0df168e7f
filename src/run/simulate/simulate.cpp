// A run: steps from row to row; if inputs are held, also from hold to hold. Steps are timed in
// blocks; after each block, its samples are recorded.
#include "elgen/simulate.hpp"

#include <fmt/ranges.h>

#include <algorithm>
#include <chrono>
#include <cmath>

#include "base/reason.hpp"
#include "elgen/evaluate.hpp"
#include "elgen/leaf_names.hpp"
#include "elgen/references.hpp"
#include "elgen/wording.hpp"
#include "model/output_units.hpp"
#include "model/requests.hpp"
#include "model/symbols.hpp"
#include "numbers/exact_number.hpp"
#include "program/evaluate/subject.hpp"
#include "run/simulate/instants.hpp"
#include "run/simulate/ranks.hpp"
#include "run/simulate/recorder.hpp"
#include "run/simulate/start.hpp"
#include "run/steps/methods.hpp"

namespace elgen {
namespace {

constexpr std::size_t block_size = 256;

constexpr const char* singular_remedy =
    "`--through singular` continues with a fixed `--step`, and E - E0 shows its accuracy; another "
    "start or other coordinates may avoid the place";

class SimulationRun {
 public:
  SimulationRun(SimulatedSystem& system, Stepper& stepper, const SimulationOptions& options,
                bool uses_compiled)
      : system_(system),
        stepper_(stepper),
        options_(options),
        end_(options.from + options.duration),
        row_instants_(options.from, end_, options.row_interval),
        hold_instants_(options.from, end_, options.input_hold_time),
        current_(first_sample(system, options)),
        recorder_(system, options, current_),
        ranks_(system, singular_remedy),
        uses_compiled_(uses_compiled) {
    block_.reserve(block_size);
  }

  Result<Trajectory> operator()() && {
    Diagnostics wrong = record_sample(current_);
    if (!wrong.empty()) return wrong;
    restart_clock();
    while (wrong.empty() && current_.t < end_) wrong = advance();
    if (!wrong.empty()) return wrong;
    Trajectory trajectory;
    trajectory.steps = steps_;
    trajectory.nanoseconds = elapsed_.count() * 1e9 / static_cast<double>(steps_ - untimed_steps_);
    trajectory.timed_code = uses_compiled_ ? "of the emitted C++" : "in the evaluator";
    Diagnostics warnings = std::move(recorder_).move_results(trajectory);
    return {std::move(trajectory), std::move(warnings)};
  }

 private:
  using Clock = std::chrono::steady_clock;

  static TrajectorySample first_sample(SimulatedSystem& system, const SimulationOptions& options) {
    TrajectorySample start{
        options.from, 0, options.row_interval.has_value(), system.start_state(), {}};
    const double* const q = start.state.data();
    if (options.input_hold_time) system.hold_inputs(q, system.v_of(start.state), start.t);
    start.inputs = system.update_inputs(q, system.v_of(start.state), start.t);
    return start;
  }

  /// Steps to the next row or hold. Records all samples before the inputs change.
  Diagnostics advance() {
    const double row = row_instants_.next();
    const double hold = hold_instants_.next();
    const double target = std::min(row, hold);
    stepper_.set_interval(current_.t, target);
    while (current_.t < target) {
      const std::optional<double> reached = stepper_.step(current_.state);
      if (!reached) {
        Diagnostics wrong = record_block();
        if (!wrong.empty()) return wrong;
        return {recorder_.run_end_error(stepper_.failure_reason(), ranks_.weakest_pivot_text(),
                                        stepper_.failure_hint())};
      }
      ++steps_;
      current_.time_since_last = *reached - current_.t;
      current_.t = *reached;
      current_.is_row = options_.row_interval && current_.t >= row;
      block_.push_back(current_);
      if (block_.size() < block_size && current_.t < target) continue;
      if (Diagnostics wrong = record_block(); !wrong.empty()) return wrong;
      if (Diagnostics wrong = compile_if_long(); !wrong.empty()) return wrong;
      if (options_.on_progress && has_final_speed()) options_.on_progress(current_.t);
    }
    if (row <= target) row_instants_.pass();
    if (hold <= target) renew_hold();
    return {};
  }

  void renew_hold() {
    hold_instants_.pass();
    if (!options_.input_hold_time) return;
    system_.hold_inputs(current_.state.data(), system_.v_of(current_.state), current_.t);
  }

  /// Records the samples of the block. `elapsed_` excludes the time of the recording.
  Diagnostics record_block() {
    elapsed_ += Clock::now() - resumed_;
    Diagnostics wrong;
    for (TrajectorySample& sample : block_) {
      sample.inputs =
          system_.update_inputs(sample.state.data(), system_.v_of(sample.state), sample.t);
      wrong = record_sample(sample);
      if (!wrong.empty()) break;
    }
    block_.clear();
    restart_clock();
    return wrong;
  }

  Diagnostics record_sample(const TrajectorySample& sample) {
    Diagnostics wrong = recorder_.add_sample(sample);
    if (!wrong.empty() || options_.continues_at_singularity) return wrong;
    return ranks_.check_ranks(sample.state, sample.t);
  }

  /// Continues with compiled functions if the interpreter has computed many instructions. Then only
  /// the steps with compiled functions are timed.
  Diagnostics compile_if_long() {
    const bool is_long = system_.interpreted_instructions() >= options_.most_interpreted;
    if (!is_long || has_final_speed() || current_.t >= end_) return {};
    has_asked_ = true;
    const Result<const CompiledModel*> compiled = options_.compile();
    restart_clock();
    if (!compiled || *compiled == nullptr) return compiled.diagnostics;
    system_.use_compiled(**compiled);
    uses_compiled_ = true;
    untimed_steps_ = steps_;
    elapsed_ = {};
    return {};
  }

  [[nodiscard]] bool has_final_speed() const { return has_asked_ || !options_.compile; }
  void restart_clock() { resumed_ = Clock::now(); }

  SimulatedSystem& system_;
  Stepper& stepper_;
  const SimulationOptions& options_;
  double end_;
  Instants row_instants_;
  Instants hold_instants_;
  TrajectorySample current_;
  Recorder recorder_;
  RankWatch ranks_;
  std::vector<TrajectorySample> block_ = {};
  std::uint64_t steps_ = 0;
  std::uint64_t untimed_steps_ = 0;  ///< before the change to compiled code
  bool has_asked_ = false;           ///< for compiled code
  bool uses_compiled_;
  Clock::time_point resumed_ = {};
  std::chrono::duration<double> elapsed_ = {};
};

std::string rotation_symbol(const Model& model, std::uint32_t index) {
  return unicode_text(symbol_of_name(model.rotations[index].name, model.rotations[index].latex));
}

/// The columns of a run; x and y of `point` are included if `point` is not empty.
std::vector<TrajectoryColumn> trajectory_columns(const SimulatedSystem& system,
                                                 const std::string& point) {
  const Model& model = system.model();
  const LeafValues<Formula> symbols = ModelSymbols(model).leaf_symbols();
  std::vector<TrajectoryColumn> columns{{"t", "s", "", false, "t"}};
  const auto name = [&](Opcode kind, std::size_t i) {
    return leaf_text(system.leaves(), kind, static_cast<std::uint32_t>(i));
  };
  for (std::size_t i = 0; i < model.coordinates.size(); ++i) {
    const Coordinate& coordinate = model.coordinates[i];
    const std::string symbol = unicode_text(symbols.q[i]);
    columns.push_back({name(Opcode::coordinate, i), coordinate.unit_text,
                       coordinate.rotation ? rotation_symbol(model, *coordinate.rotation) : symbol,
                       false, symbol});
  }
  for (std::size_t i = 0; i < model.velocities.size(); ++i) {
    const Velocity& velocity = model.velocities[i];
    const std::string& unit = model.coordinates[velocity.coordinate].unit_text;
    const std::string rate = unit.empty() ? "" : unit + "/s";
    columns.push_back({name(Opcode::velocity, i), velocity.rotation ? "rad/s" : rate, "", false,
                       unicode_text(symbols.v[i])});
  }
  for (std::size_t k = 0; k < model.inputs.size(); ++k) {
    const Input& input = model.inputs[k];
    if (!system.laws()[k].expression) continue;
    const std::string symbol = unicode_text(symbols.u[k]);
    columns.push_back({input.name, input.unit_text, symbol, false, symbol});
  }
  for (std::size_t k = 0; k < model.constraints.size(); ++k) {
    const FieldEntry place{OutputKind::forward_dynamics, "multipliers", k, 0};
    const bool is_number = unit_of_entry(model, place) == Unit{};
    columns.push_back({"lambda_" + model.constraints[k].name,
                       is_number ? "" : unit_text_of_entry(model, place), "", false,
                       unicode_text(symbols.multipliers[k])});
  }
  const bool is_in_units = has_units(model);
  for (const char* axis : {"x", "y"}) {
    if (point.empty()) break;
    const std::string name_of_axis = fmt::format("{}({})", axis, point);
    columns.push_back({name_of_axis, is_in_units ? "m" : "", "", false, name_of_axis});
  }
  columns.push_back(
      {"E", is_in_units ? "J" : "", system.does_work() ? "E − E₀ − work" : "E − E₀", true});
  return columns;
}

/// E201, with a similar known name as suggestion, or the list of known names.
Diagnostic unknown_name_error(std::string_view kind, const std::string& name,
                              const std::vector<std::string>& known) {
  const std::string all =
      known.empty() ? "there are none" : fmt::format("there are: {}", fmt::join(known, ", "));
  return {Reason::unknown_column,
          {},
          fmt::format("unknown {} `{}`", kind, name),
          suggestion(name, known, all)};
}

/// Assigns a panel to each column in options.panel_columns. E201 for an unknown column or point.
Diagnostics choose_curves(const SimulationOptions& options, const Model& model,
                          std::vector<TrajectoryColumn>& columns) {
  Diagnostics wrong;
  for (const std::string& each : options.panel_columns) {
    const std::string name = component_name(model, collapse_blanks(each));
    const auto found = std::ranges::find(columns, name, &TrajectoryColumn::name);
    if (found == columns.end()) {
      wrong.push_back(
          unknown_name_error("column", name, column_words(columns, &TrajectoryColumn::name)));
    } else if (found->panel.empty()) {
      found->panel = found->symbol;
    }
  }
  const std::vector<std::string> points = column_words(model.points, &Point::name);
  if (!options.path.empty() && std::ranges::count(points, options.path) == 0) {
    wrong.push_back(unknown_name_error("point", options.path, points));
  }
  return wrong;
}

/// The common unit of all rows of a field of constraint_residual; "" if their units differ, are
/// unknown or 1.
std::string common_unit(const Model& model, std::string_view field, Extent rows) {
  std::vector<std::optional<Unit>> units;
  for (std::size_t row = 0; row < extent_size(model, rows); ++row) {
    units.push_back(unit_of_entry(model, {OutputKind::constraint_residual, field, row, 0}));
  }
  const auto other = std::ranges::find_if(
      units, [&](const std::optional<Unit>& unit) { return unit != units.front(); });
  const bool has_one = other == units.end() && units.front() && *units.front() != Unit{};
  return has_one ? to_string(*units.front()) : "";
}

/// The corrections of q and v that are visible in printed numbers. `columns`: t, q, v, ...
std::vector<StartCorrection> start_corrections(const Model& model, const Model& assembled,
                                               const std::vector<TrajectoryColumn>& columns) {
  const Numbers from = stated_start(model);
  const Numbers to = stated_start(assembled);
  std::vector<StartCorrection> moves;
  for (std::size_t i = 0; i < from.size(); ++i) {
    if (!is_visible_change(from[i], to[i])) continue;
    moves.push_back({columns[i + 1].name, columns[i + 1].unit, to[i] - from[i]});
  }
  return moves;
}

void add_units(ConstraintAccuracy& kept, const Model& model) {
  const bool has_positions = extent_size(model, Extent::positions) > 0;
  if (has_positions) kept.unit = common_unit(model, "position", Extent::positions);
  kept.rate_unit = common_unit(model, "rate", Extent::constraints);
}

/// E518 for each constant law beyond the limits of its input. The run applies such a law without
/// clamping.
Diagnostics check_law_limits(SimulatedSystem& system, double t) {
  Diagnostics found;
  const Model& model = system.model();
  const Numbers start = system.start_state();
  for (std::size_t k = 0; k < model.inputs.size(); ++k) {
    const Input& input = model.inputs[k];
    const std::optional<ExpressionId>& law = system.laws()[k].expression;
    if (!input.limits || !law || !is_constant_along_run(model, *law)) continue;
    const double value = system.value(*law, start.data(), system.v_of(start), t);
    const auto low = to_double(input.limits->low);
    const auto high = to_double(input.limits->high);
    if (!(value < low || value > high)) continue;
    const Span& span = model.expressions[*law].span;
    found.push_back(
        {Code::E518, span,
         fmt::format("{} is beyond [{:g}, {:g}], the limits of `{}`, but is applied unchanged",
                     in_backticks(span), low, high, input.name)});
  }
  return found;
}

/// The outputs that both pages and runs call.
std::string common_outputs(const Model& model) {
  std::string names =
      "mass_matrix,dissipation,applied_force,momentum,energy_function,forward_dynamics";
  if (!model.inputs.empty()) names += ",input_matrix";
  if (!model.rotations.empty()) names += ",coordinate_rates,normalized";
  if (!model.constraints.empty()) names += ",constraint_residual,constraint_jacobian,projected";
  return names;
}

std::string outputs_of_page(const CheckedModel& checked) {
  std::string names = common_outputs(checked.model);
  for (const auto& [number, shown] : checked.scene.page_outputs) {
    names += "," + checked.model.outputs[number].name;
  }
  return names;
}

}  // namespace

std::string outputs_for_run(const Model& model) {
  std::string names = common_outputs(model) + ",position_gradient";
  if (!has_combined_lagrangian(model)) names += ",kinetic_energy,total_energy";
  return names;
}

/// The products for a run. Runs the pipeline twice: the outputs depend on the checked model.
Products derive_for_run(const PipelineSources& inputs, PipelineOptions options,
                        const std::optional<StepSpec>& step) {
  PipelineOptions first = options;
  first.goals = {Goal::check};
  Products checked = run_pipeline(inputs, first);
  if (!checked.checked) return checked;
  const bool is_page = options.scene.purpose.shows_motion;
  const std::string outputs =
      is_page ? outputs_of_page(*checked.checked) : outputs_for_run(checked.checked->model);
  options.scene.outputs = {make_source("outputs of a run", outputs)};
  options.scene.step = step;
  Products products = run_pipeline(inputs, options);
  if (!products.checked) return products;
  Scene& scene = products.checked->scene;
  scene.emission = {.language = is_page ? LanguageId::javascript : default_language,
                    .name_space = scene.emission.name_space,
                    .has_batch_header = step && !is_page,
                    .has_page = false};
  scene.numerics = {.inner = options.scene.inner};
  return products;
}

Result<CompiledHeaders> compile_for_run(const Products& products, const Limits& limits) {
  const auto& [model, scene] = *products.checked;
  const Result<EmittedFiles> files = emit(model, scene, *products.program, {});
  if (!files) return files.diagnostics;
  return compile(*files, model, scene, *products.program, {limits});
}

Result<Trajectory> simulate(const CheckedModel& checked, const Program& program,
                            const CompiledModel* compiled, const SimulationOptions& options) {
  const Result<MethodRow> method = find_method(options);
  if (!method) return method.diagnostics;
  const Result<StepRule> rule = step_rule(*method, options);
  if (!rule) return rule.diagnostics;
  const Result<CheckedModel> assembled = assemble_start(checked, exact_value(options.from));
  if (!assembled) return assembled.diagnostics;
  SimulatedSystem system(*assembled, program, compiled, options.projects);
  std::vector<TrajectoryColumn> columns = trajectory_columns(system, options.path);
  Diagnostics refused = choose_curves(options, checked.model, columns);
  if (refused.empty()) refused = check_singular_start(system, system.start_state(), options.from);
  if (!refused.empty()) return refused;
  const std::unique_ptr<Stepper> stepper = method->make_stepper(system, *rule);
  Result<Trajectory> trajectory = SimulationRun(system, *stepper, options, compiled != nullptr)();
  if (!trajectory) return trajectory;
  trajectory->model = checked.scene.base_name;
  trajectory->method = method->name;
  if (options.order && *options.order != method->order)
    trajectory->method += fmt::format(" of order {}", *options.order);
  trajectory->title = checked.model.title;
  trajectory->from = options.from;
  trajectory->columns = std::move(columns);
  trajectory->path = options.path;
  if (trajectory->constraints) {
    trajectory->constraints->start =
        start_corrections(checked.model, assembled->model, trajectory->columns);
    add_units(*trajectory->constraints, checked.model);
  }
  const Diagnostics beyond = check_law_limits(system, options.from);
  trajectory.diagnostics.insert(trajectory.diagnostics.end(), beyond.begin(), beyond.end());
  return trajectory;
}

}  // namespace elgen
