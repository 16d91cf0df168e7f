// elgen tradeoff: prints a table of measured designs of one output, or of measured runs. The file
// of the table and the scene of a picked row are written together or not at all.
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <optional>
#include <string>
#include <utility>

#include "base/reason.hpp"
#include "cli/commands.hpp"
#include "cli/files/data_formats.hpp"
#include "cli/files/inputs.hpp"
#include "cli/options.hpp"
#include "cli/process/resources.hpp"
#include "cli/process/terminal.hpp"
#include "elgen/bench.hpp"

namespace elgen::cli {
namespace {

/// The options for the table, and for a picked row.
struct TradeoffOutput {
  std::string format = {};  ///< format on stdout; empty: follows --format
  FileOption table = {};
  std::optional<double> max_error = {};  ///< the cheapest row within this error is picked
  std::string scene_file = {};           ///< for the scene of the picked row; empty: no scene
};

struct TradeoffOptions {
  std::string input = {};
  std::string measured_output = {};  ///< the output to measure
  std::optional<double> time = {};   ///< duration of runs in s; none: an output is measured
  std::vector<double> lengths = {};  ///< lengths of the steps of these runs, in s
  DesignChoices choices = {};
  std::vector<SourcePointer> ranges = {};
  std::vector<SourcePointer> over = {};  ///< ranges of parameters
  std::string states_file = {};          ///< log of a run; empty: states are drawn
  TradeoffOutput output = {};
};

/// The path of the model, relative to the scene's folder.
std::string model_path(const PipelineSources& inputs, const std::string& scene_file) {
  namespace fs = std::filesystem;
  const auto from_root = [](const fs::path& path) { return fs::absolute(path).lexically_normal(); };
  return from_root(inputs.model->path)
      .lexically_proximate(from_root(scene_file).parent_path())
      .generic_string();
}

Diagnostics no_design_errors(const TradeoffTable& table, double max_error) {
  const TradeoffRow* const nearest = most_accurate_row(table);
  return {{Code::E632,
           {},
           fmt::format("no design has a worst error of at most {}", max_error),
           nearest == nullptr
               ? ""
               : fmt::format("the most accurate design is `{}`, with a worst error {} {:.1e}",
                             name_of(*nearest), nearest->is_below_reference ? "below" : "of",
                             nearest->error.worst)}};
}

/// Picks the cheapest row within --max-error; E632 if there is none. If --write-scene is set,
/// appends the scene of the row to `files`. If the rows are designs of an output and their states
/// are drawn, as in `verify`, the scene also requires this `max_error`.
ExitCode choose_row(const GlobalOptions& global, const TradeoffOptions& options,
                    const PipelineSources& inputs, const TradeoffTable& table,
                    std::vector<OutputFile>& files) {
  const TradeoffOutput& output = options.output;
  const TradeoffRow* const row = cheapest_accurate_row(table, *output.max_error);
  if (row == nullptr) return report(global, no_design_errors(table, *output.max_error));
  if (output.scene_file.empty()) return ExitCode::success;
  const std::string subject = row->design.step ? "" : table.subject;
  const Result<SingleOutputModel> base =
      read_single_output_model({inputs, subject, {}, options.ranges}, global.limits);
  if (!base) return report(global, base.diagnostics);
  const std::string path = model_path(inputs, output.scene_file);
  DesignSource from = base->design_source();
  if (!row->design.step && options.states_file.empty()) from.max_error = output.max_error;
  files.push_back({output.scene_file, scene_text(from, row->design, path), ReplacePolicy::never});
  return ExitCode::success;
}

/// E913 for an unknown file ending; E703 or E708 if a file may not be written.
Diagnostics check_table_output(const TradeoffOutput& output) {
  if (!output.table.file.empty()) {
    const auto format = select_format<TradeoffTable>(output.table.file);
    if (!format) return format.diagnostics;
  }
  std::vector<OutputFile> files;
  for (const std::string& path : {output.table.file, output.scene_file}) {
    if (!path.empty()) files.push_back({path, "", ReplacePolicy::never});
  }
  return check_output_paths(files, output.table.force);
}

/// Prints and writes a ranked table, and the scene of the picked row if output.scene_file is set.
/// E632 if no row is within max_error; E706 if a file cannot be written.
ExitCode write_results(const GlobalOptions& global, const TradeoffOptions& options,
                       const PipelineSources& inputs, const TradeoffTable& table) {
  const TradeoffOutput& output = options.output;
  const std::string as = output.format.empty() && wants_json(global) ? "json" : output.format;
  const auto printed = select_format<TradeoffTable>("." + as);
  ExitCode worst = print(global, printed ? printed->text(table) : to_text(table));
  std::vector<OutputFile> files;
  if (!output.table.file.empty()) {
    const auto format = select_format<TradeoffTable>(output.table.file);
    files.push_back({output.table.file, format->text(table), ReplacePolicy::never});
  }
  if (output.max_error) {
    worst = std::max(worst, choose_row(global, options, inputs, table, files));
  }
  const auto written = write_files(files, {output.table.force, global.limits.seconds});
  return std::max(worst, report(global, written.diagnostics));
}

/// Measures the designs or the runs, and shows the stages on a line that is cleared at the end.
Result<MeasuredTable> measure_with_progress(const GlobalOptions& global,
                                            const TradeoffOptions& options,
                                            const PipelineSources& inputs) {
  const Progress progress(options.input);
  const BenchOptions process{global.limits,
                             [&progress](const std::string& name) { progress.show_stage(name); },
                             [&global] { renew_time_limit(global.limits); }};
  if (options.time) return measure_runs({inputs, *options.time, options.lengths}, process);
  DesignRequest request{inputs, options.measured_output, options.choices, options.ranges,
                        options.over};
  if (!options.states_file.empty()) {
    const Result<SourcePointer> log = read_source(options.states_file, global.limits);
    if (!log) return log.diagnostics;
    request.log = *log;
  }
  return measure_designs(request, process);
}

/// E913 if a scene should be written for a model on standard input: a scene names the file of its
/// model.
Diagnostics check_scene_output(const TradeoffOptions& options, const PipelineSources& inputs) {
  if (options.output.scene_file.empty() || inputs.model->path != stdin_name) return {};
  return {{Reason::stdin_in_scene, {}, "a scene cannot name a model on standard input"}};
}

ExitCode measure_input(const GlobalOptions& global, const TradeoffOptions& options) {
  const Result<PipelineSources> inputs = read_inputs(options.input, global.limits);
  if (!inputs) return report(global, inputs.diagnostics);
  const Diagnostics refused = check_scene_output(options, *inputs);
  if (!refused.empty()) return report(global, refused);
  Result<MeasuredTable> result = measure_with_progress(global, options, *inputs);
  ExitCode found = report(global, result.diagnostics);
  if (!result) return found;
  if (!result->compiler_errors.empty()) {
    // The designs without compiler errors were measured, so the exit code does not report an
    // internal error.
    report(global, result->compiler_errors);
    found = ExitCode::inaccessible;
  }
  result->table.max_error = options.output.max_error;
  return std::max(found,
                  write_results(global, options, *inputs, rank_rows(std::move(result->table))));
}

ExitCode run_tradeoff(const GlobalOptions& global, const TradeoffOptions& options) {
  const Diagnostics wrong = check_table_output(options.output);
  return wrong.empty() ? measure_input(global, options) : report(global, wrong);
}

/// Adds an option for each dimension of designs.
void add_dimension_options(CLI::App& command, DesignChoices& choices) {
  for (const DesignDimension& dimension : design_dimensions()) {
    const auto pin = [&choices, name = dimension.name](const std::string& value) {
      choices.pinned.push_back({name, value});
    };
    command.add_option_function<std::string>("--" + dimension.name, pin, dimension.doc)
        ->check(CLI::IsMember(dimension.values))
        ->excludes(command.get_option("--trajectory"));
  }
}

/// Adds the options that select the designs and the ranges of their states, or the runs.
void add_subject_options(CLI::App& command, TradeoffOptions& options) {
  CLI::Option* const time = add_number_option(
      command, "--trajectory", options.time,
      "measure runs of this length in s with all emitted step methods, instead of an output");
  command.add_option("--steps", options.lengths, "step lengths of these runs in s: 1e-2,1e-3")
      ->type_name("LIST")
      ->delimiter(',')
      ->allow_extra_args(false)
      ->needs(time);
  command
      .add_option("--of", options.measured_output, "output to measure (default: inverse_dynamics)")
      ->type_name("OUTPUT")
      ->excludes(time);
  command
      .add_option(
          "--dimensions", options.choices.more,
          "further dimensions: inner, a wider scalar between doubles; order, the order of an "
          "expansion about the start; trigonometry, sines with errors of 4e-16 and 1e-7 and of the "
          "library; form, every design also as typed")
      ->type_name("LIST")
      ->delimiter(',')
      ->allow_extra_args(false)
      ->excludes(time);
  add_dimension_options(command, options.choices);
  add_source_option(command, "--range", "NAME=LOW..HIGH", options.ranges,
                    "range in which errors are measured: theta=-0.1..0.1");
  add_source_option(command, "--over", "NAME=LOW:HIGH", options.over,
                    "range of a parameter over which errors are measured: m=0.1:10");
  command
      .add_option("--states", options.states_file,
                  "log of a run, at whose rows errors are measured: run.csv of simulate")
      ->type_name("FILE");
  for (const char* const option : {"--range", "--over", "--states"}) {
    command.get_option(option)->excludes(time);
  }
}

/// Adds the options for the table, and for the scene of the picked row.
void add_output_options(CLI::App& command, TradeoffOutput& output) {
  CLI::Option* const max_error =
      add_number_option(command, "--max-error", output.max_error,
                        "pick the cheapest design whose worst error is at most this");
  command.add_option("--write-scene", output.scene_file, "write that design as a scene")
      ->type_name("FILE")
      ->needs(max_error);
  command.add_option("--as", output.format, "format of the table: text (default), json or csv")
      ->check(CLI::IsMember({"text", "json", "csv"}));
  add_file_options(command, output.table, "write the table (.svg, .json or .csv)");
}

}  // namespace

void add_tradeoff(CLI::App& app, Action& action) {
  CLI::App* command = app.add_subcommand("tradeoff", "measure speed against accuracy");
  const auto options = std::make_shared<TradeoffOptions>();
  command->add_option("input", options->input, "NAME.toml, NAME.scene.toml or - (stdin)")
      ->required();
  add_subject_options(*command, *options);
  add_output_options(*command, options->output);
  set_action(*command, action, options, &run_tradeoff);
}

}  // namespace elgen::cli
