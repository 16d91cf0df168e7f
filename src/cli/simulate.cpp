// elgen simulate: simulates a model or scene from its start. Prints the last state and the drifts,
// and writes the rows to the file of -o.
#include "elgen/simulate.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "base/reason.hpp"
#include "cli/commands.hpp"
#include "cli/files/data_formats.hpp"
#include "cli/files/inputs.hpp"
#include "cli/process/resources.hpp"
#include "cli/process/terminal.hpp"
#include "cli/shown_pipeline.hpp"
#include "elgen/player.hpp"
#include "elgen/wording.hpp"

namespace elgen::cli {

namespace {

struct SimulateOptions {
  std::string input = {};
  SceneOptions scene = {};
  SimulationOptions run = {};
  FileOption output = {};  ///< file of the rows
};

constexpr const char* default_method = "dopri5";

/// The number of rows if --every is not set.
constexpr double default_rows = 1000;

/// The function for SimulationOptions::on_progress. One second after its first call, it estimates
/// the duration of the run. If the estimate is ten seconds or more, the function shows it once: in
/// the line of progress on a terminal, otherwise as a message.
std::function<void(double)> make_duration_estimator(const GlobalOptions& global,
                                                    const Progress& progress, double begin,
                                                    double time) {
  using Clock = std::chrono::steady_clock;
  std::optional<Clock::time_point> first;
  return [&global, &progress, begin, time, first, from = begin, is_over = false](double t) mutable {
    if (!first) {
      first = Clock::now();
      from = t;
    }
    const double seconds = std::chrono::duration<double>(Clock::now() - *first).count();
    if (is_over || seconds < 1 || t <= from) return;
    is_over = true;
    const double whole = seconds * time / (t - from);
    if (whole < 10) return;
    const bool is_beyond = whole > static_cast<double>(global.limits.seconds);
    const std::string text =
        fmt::format("{:.3g} of {:.3g} s after {:.1f} s, the whole run will take about {:.2g} s{}",
                    t - begin, time, seconds, whole, is_beyond ? " (--limit seconds=N)" : "");
    progress.show_stage("simulate: " + text);
    if (!is_terminal(stderr)) print_message(global, text);
  };
}

/// Runs derive_for_run() and shows its stages. The line of progress is cleared before this returns.
Products derive_with_progress(const SimulateOptions& options, const PipelineSources& inputs,
                              PipelineOptions pipeline) {
  const Progress progress(options.input);
  pipeline.on_stage = [&progress](const std::string& stage) { progress.show_stage(stage); };
  return derive_for_run(inputs, std::move(pipeline), step_for_run(options.run));
}

/// E910 if the rows need more memory than the limit. Each row has t, q, v and E, as numbers and as
/// texts of at least two characters.
Diagnostics check_row_memory(const SimulationOptions& run, const Model& model,
                             const Limits& limits) {
  if (!run.row_interval) return {};
  const std::size_t numbers = model.coordinates.size() + model.velocities.size() + 2;
  const std::size_t bytes = sizeof(std::vector<double>) + numbers * (sizeof(double) + 2);
  const double rows = run.duration / *run.row_interval;
  if (rows * static_cast<double>(bytes) <= static_cast<double>(limits.memory_mib) * 0x1p20)
    return {};
  return {{Code::E910,
           {},
           fmt::format("`--every {}` gives {:.3g} rows, which take more than {} MiB of memory",
                       *run.row_interval, rows, limits.memory_mib),
           "give a longer `--every`, or raise --limit memory_mib=N"}};
}

Result<Trajectory> run_simulation(const GlobalOptions& global, const SimulateOptions& options,
                                  const Products& products) {
  SimulationOptions run = options.run;
  const bool has_rows = !options.output.file.empty() || wants_json(global);
  if (has_rows && !run.row_interval) run.row_interval = run.duration / default_rows;
  Diagnostics refused = check_row_memory(run, products.checked->model, global.limits);
  if (!refused.empty()) return refused;
  const Progress progress(options.input);
  Result<CompiledHeaders> headers = CompiledHeaders();
  const auto compile = [&]() -> Result<const CompiledModel*> {
    progress.show_stage("compile");
    headers = compile_for_run(products, global.limits);
    const bool has_no_compiler = !headers && headers.diagnostics.front().code == Code::E704;
    if (!headers && !has_no_compiler) return headers.diagnostics;
    progress.show_stage("simulate");
    renew_time_limit(global.limits);
    return has_no_compiler ? nullptr : headers->front().functions.get();
  };
  // A program with a `step` is always interpreted.
  if (!step_for_run(run)) run.compile = compile;
  progress.show_stage("simulate");
  renew_time_limit(global.limits);
  run.on_progress = make_duration_estimator(global, progress, run.from, run.duration);
  return simulate(*products.checked, *products.program, nullptr, run);
}

bool writes_page(const SimulateOptions& options) { return options.output.file.ends_with(".html"); }

/// The options of a page's run. By default, the scene's `step` gives the method; without `step` it
/// is dopri5. Other methods than dopri5 make ten thousand steps of equal length by default.
SimulationOptions page_run_options(SimulationOptions run, const std::optional<StepSpec>& of_scene) {
  constexpr double default_steps = 10'000;
  const bool is_open = run.method.empty() && !run.order && !run.step && !run.tolerance;
  if (is_open && of_scene) {
    run.method = step_method_row(of_scene->method).name;
    run.order = step_order(*of_scene);
  }
  if (run.method.empty()) run.method = default_method;
  const bool has_control = run.method == default_method || run.tolerance;
  if (!run.step && !has_control) run.step = run.duration / default_steps;
  return run;
}

/// The `step` that the scene requests; none also if the inputs have errors.
std::optional<StepSpec> find_scene_step(const PipelineSources& inputs, PipelineOptions pipeline) {
  pipeline.goals = {Goal::check};
  const Products products = run_pipeline(inputs, pipeline);
  if (!products.checked) return std::nullopt;
  const std::vector<OutputRequest>& requests = products.checked->scene.outputs;
  const auto found = std::ranges::find(requests, OutputKind::step, &OutputRequest::kind);
  return found == requests.end() ? std::nullopt : found->step;
}

/// Products with the textbook steps for the page; for a model without constraints, also with the
/// equilibria and normal modes, if elgen finds them.
Products derive_page_texts(const SimulateOptions& options, const PipelineSources& inputs,
                           PipelineOptions pipeline, bool is_constrained) {
  pipeline.scene.purpose = purpose::rest;
  pipeline.goals = {Goal::steps};
  if (!is_constrained) pipeline.goals.push_back(Goal::modes);
  return run_pipeline_with_progress(options.input, inputs, pipeline);
}

ExitCode write_page(const GlobalOptions& global, const SimulateOptions& options) {
  SimulationOptions run = page_run_options(options.run, {});
  Diagnostics refused = check_run_options(run);
  if (refused.empty()) refused = check_player_options(run);
  if (refused.empty()) {
    refused =
        check_output_paths({{options.output.file, "", ReplacePolicy::never}}, options.output.force);
  }
  if (!refused.empty()) return report(global, refused);
  const Result<PipelineSources> inputs = read_inputs(options.input, global.limits);
  if (!inputs) return report(global, inputs.diagnostics);
  PipelineOptions pipeline = pipeline_options(global, {Goal::choose});
  pipeline.scene = options.scene;
  run = page_run_options(options.run, find_scene_step(*inputs, pipeline));
  const Products moving = derive_with_progress({.input = options.input, .run = run}, *inputs,
                                               player_pipeline_options(pipeline));
  const ExitCode derived = report_products(global, moving);
  print_stage_times(global, moving);
  if (derived != ExitCode::success || !global.stop_after.empty()) return derived;
  const Products read =
      derive_page_texts(options, *inputs, pipeline, !moving.checked->model.constraints.empty());
  const Result<std::string> page = player_page(moving, read, run, global.limits);
  const ExitCode reported_code = report(global, page.diagnostics);
  if (!page) return reported_code;
  const auto written = write_files({{options.output.file, *page, ReplacePolicy::never}},
                                   {options.output.force, global.limits.seconds});
  return std::max(reported_code, report(global, written.diagnostics));
}

/// E913 if `--show` or `--path` is set but the output is no plot.
Diagnostics check_curve_options(const SimulateOptions& options) {
  const bool has_curves = !options.run.panel_columns.empty() || !options.run.path.empty();
  if (!has_curves || options.output.file.ends_with(".svg")) return {};
  return {
      {Reason::option_of_plots, {}, "`--show` and `--path` apply to plots: give `-o FILE.svg`"}};
}

ExitCode simulate_input(const GlobalOptions& global, const SimulateOptions& given) {
  if (Diagnostics refused = check_curve_options(given); !refused.empty())
    return report(global, refused);
  if (writes_page(given)) return write_page(global, given);
  SimulateOptions options = given;
  if (options.run.method.empty()) options.run.method = default_method;
  Diagnostics refused = check_run_options(options.run);
  if (options.run.row_interval && options.output.file.empty() && !wants_json(global)) {
    refused.push_back({Reason::option_of_runs,
                       {},
                       "`--every` applies to rows: give `-o FILE` or `--format json`"});
  }
  if (!refused.empty()) return report(global, refused);
  Result<DataFormat<Trajectory>> format;
  if (!options.output.file.empty()) {
    format = select_format<Trajectory>(options.output.file, data_formats<Trajectory>, "html");
    if (!format) return report(global, format.diagnostics);
    refused = check_output_path(options.output);
    if (!refused.empty()) return report(global, refused);
  }
  const Result<PipelineSources> inputs = read_inputs(options.input, global.limits);
  if (!inputs) return report(global, inputs.diagnostics);
  PipelineOptions pipeline = pipeline_options(global, {Goal::choose});
  pipeline.scene = options.scene;
  pipeline.scene.purpose = purpose::simulate;
  const Products products = derive_with_progress(options, *inputs, pipeline);
  const ExitCode derived = report_products(global, products);
  print_stage_times(global, products);
  if (derived != ExitCode::success || !global.stop_after.empty()) return derived;
  const Result<Trajectory> trajectory = run_simulation(global, options, products);
  const ExitCode reported_code = report(global, trajectory.diagnostics);
  if (!trajectory) return reported_code;
  const ExitCode exit_code = trajectory->loses_energy ? ExitCode::differs : reported_code;
  const ExitCode printed = std::max(
      exit_code, print(global, wants_json(global) ? to_json(*trajectory) : to_text(*trajectory)));
  if (options.output.file.empty()) return printed;
  const auto written = write_output(global, options.output, (*format).text(*trajectory));
  return std::max(printed, report(global, written.diagnostics));
}

void add_run_options(CLI::App& command, SimulationOptions& run) {
  command.add_option("--time", run.duration, "duration in s")->check(unit_error)->required();
  command.add_option("--from", run.from, "time at the start in s")
      ->check(unit_error)
      ->capture_default_str();
  run.method.clear();  // pages of scenes with `step` have another default
  command.add_option("--method", run.method, "dopri5 (default), rk4, verlet or midpoint");
  command.add_option_function<std::uint32_t>(
      "--order", [&run](std::uint32_t given) { run.order = given; },
      "order of verlet and midpoint: 2 (default), 4 or 8");
  add_number_option(command, "--step", run.step, "largest length of a step in s");
  add_number_option(command, "--tolerance", run.tolerance,
                    "allowed error of dopri5 steps with variable length (default: 1e-9)");
  add_number_option(command, "--every", run.row_interval,
                    "time between rows in s (default: a thousandth of --time)");
  add_number_option(command, "--hold", run.input_hold_time,
                    "hold the inputs constant for this time in s");
  command.add_option("--show", run.panel_columns, "also plot these rates and multipliers")
      ->type_name("NAME,…")
      ->delimiter(',')
      ->allow_extra_args(false);
  command.add_option("--path", run.path, "plot the path of this point, y over x")
      ->type_name("POINT")
      ->excludes("--show");
  command
      .add_option_function<std::string>(
          "--project", [&run](const std::string& given) { run.projects = given == "on"; },
          "project the state onto the constraints after each step (default: on)")
      ->check(CLI::IsMember({"on", "off"}));
  command
      .add_option_function<std::string>(
          "--through", [&run](const std::string&) { run.continues_at_singularity = true; },
          "singular: continue with fixed steps if M or the constraints lose rank")
      ->check(CLI::IsMember({"singular"}));
}

}  // namespace

void add_simulate(CLI::App& app, Action& action) {
  CLI::App* command = app.add_subcommand("simulate", "integrate a model or scene over time");
  const auto options = std::make_shared<SimulateOptions>();
  command->add_option("input", options->input, "NAME.toml, NAME.scene.toml or - (stdin)")
      ->required();
  add_run_options(*command, options->run);
  add_source_option(*command, "--state", "NAME=VALUE,…", options->scene.starts,
                    "start state: theta=1, dot(theta)=0, attitude=[1,0,0,0]");
  add_source_option(*command, "--set", "NAME=VALUE", options->scene.values, "value of a parameter");
  add_source_option(*command, "--input", "NAME=LAW", options->scene.laws,
                    "value or law of an input: u=-3*theta - dot(theta)");
  add_file_options(*command, options->output,
                   "write the rows (.csv, .json), a plot (.svg) or an animated page (.html)");
  add_specialisation_options(*command, options->scene);
  set_action(*command, action, options, &simulate_input);
}

}  // namespace elgen::cli
