// elgen tradeoff: a table of the designs of one output on stdout, a picture or data where -o says.
#include "elgen/tradeoff.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <functional>

#include "cli/commands.hpp"
#include "cli/designs.hpp"
#include "cli/files/data_formats.hpp"
#include "cli/files/inputs.hpp"
#include "cli/files/output_files.hpp"
#include "cli/runs.hpp"

namespace elgen::cli {

namespace {

struct TradeoffOptions {
  std::string input = {};
  std::string output = {};
  std::optional<double> time = {};  ///< of runs, in the place of an output
  std::vector<std::string> dimensions = {};
  std::vector<SourcePointer> ranges = {};
  std::optional<double> max_error = {};
  std::string scene_file = {};  ///< of the cheapest within max_error; empty: none
  std::string format = "text";
  std::string file = {};  ///< of the table; empty: none
  bool force = false;
};

/// E913, and what stands in the place of a file.
Diagnostics refused(const TradeoffOptions& options) {
  if (!options.file.empty()) {
    const auto format = format_of<TradeoffTable>(options.file);
    if (!format) return format.diagnostics;
  }
  std::vector<OutputFile> files;
  for (const std::string& path : {options.file, options.scene_file}) {
    if (!path.empty()) files.push_back({path, "", Replaces::nothing});
  }
  return refuse_places(files, options.force);
}

/// From the folder of the scene.
std::string model_path(const Inputs& inputs, const std::string& scene_file) {
  namespace fs = std::filesystem;
  const auto from_root = [](const fs::path& path) { return fs::absolute(path).lexically_normal(); };
  return from_root(inputs.model->path)
      .lexically_proximate(from_root(scene_file).parent_path())
      .generic_string();
}

std::string scene_of(const MeasuredDesigns& measured, const TradeoffRow& row, const Inputs& inputs,
                     const std::string& scene_file) {
  const DesignBase base{measured.checked, measured.scene ? &*measured.scene : nullptr};
  return scene_text(base, design_of(measured, row), model_path(inputs, scene_file));
}

Diagnostics none_within(const TradeoffTable& table, double max_error) {
  const TradeoffRow* const nearest = most_accurate(table);
  return {{Code::E632,
           {},
           fmt::format("no design is within {}", max_error),
           nearest == nullptr ? ""
                              : fmt::format("`{}` is nearest, its worst error is {:.1e}",
                                            name_of(*nearest), nearest->error.worst)}};
}

/// Writes the scene of a row.
using SceneOf = std::function<std::string(const TradeoffRow&)>;

/// The row that --max-error asks for; its scene joins `files`.
ExitCode choose_row(const GlobalOptions& global, const TradeoffOptions& options,
                    const TradeoffTable& table, const SceneOf& scene_of_row,
                    std::vector<OutputFile>& files) {
  const TradeoffRow* const row = cheapest_within(table, *options.max_error);
  if (row == nullptr) return report(global, none_within(table, *options.max_error));
  tell(global, fmt::format("cheapest within {}: {}, {:.4g} ns, error {:.1e}", *options.max_error,
                           name_of(*row), row->cost.median, row->error.worst));
  if (!options.scene_file.empty()) {
    files.push_back({options.scene_file, scene_of_row(*row), Replaces::nothing});
  }
  return ExitCode::success;
}

ExitCode finish(const GlobalOptions& global, const TradeoffOptions& options,
                const TradeoffTable& table, const SceneOf& scene_of_row) {
  const auto printed = format_of<TradeoffTable>("." + options.format);
  ExitCode worst = print(global, printed ? printed->text(table) : to_text(table));
  std::vector<OutputFile> files;
  if (!options.file.empty()) {
    const auto format = format_of<TradeoffTable>(options.file);
    files.push_back({options.file, format->text(table), Replaces::nothing});
  }
  if (options.max_error) {
    worst = std::max(worst, choose_row(global, options, table, scene_of_row, files));
  }
  const auto written = write_files(files, {options.force, global.limits.seconds});
  return std::max(worst, report(global, written.diagnostics));
}

ExitCode tabulate_designs(const GlobalOptions& global, const TradeoffOptions& options,
                          const Inputs& inputs) {
  std::vector<SourcePointer> sources;
  const Result<MeasuredDesigns> measured =
      measured_designs({options.input, inputs, options.output, options.dimensions, options.ranges},
                       global.limits, sources);
  ExitCode worst = report(global, measured.diagnostics);
  if (!measured) return worst;
  if (!measured->not_compiled.empty()) {
    // The others are measured all the same, so it is no mistake of elgen's alone.
    report(global, measured->not_compiled);
    worst = ExitCode::inaccessible;
  }
  const auto scene_of_row = [&](const TradeoffRow& row) {
    return scene_of(*measured, row, inputs, options.scene_file);
  };
  return std::max(worst, finish(global, options, measured->table, scene_of_row));
}

ExitCode tabulate_runs(const GlobalOptions& global, const TradeoffOptions& options,
                       const Inputs& inputs) {
  const Result<TradeoffTable> table =
      measured_runs({options.input, inputs, *options.time}, global.limits);
  const ExitCode found = report(global, table.diagnostics);
  return table ? std::max(found, finish(global, options, *table, {})) : found;
}

ExitCode tradeoff_input(const GlobalOptions& given, const TradeoffOptions& options) {
  GlobalOptions global = given;
  if (options.format == "json") global.style.format = DiagnosticFormat::json;
  const Diagnostics wrong = refused(options);
  if (!wrong.empty()) return report(global, wrong);
  const Result<Inputs> inputs = read_inputs(options.input, global.limits);
  if (!inputs) return report(global, inputs.diagnostics);
  if (!options.scene_file.empty() && inputs->model->path == stdin_name) {
    return report(global, {{Code::E913, {}, "a scene cannot name a model on standard input"}});
  }
  return options.time ? tabulate_runs(global, options, *inputs)
                      : tabulate_designs(global, options, *inputs);
}

/// Of what designs there are, and where they are looked at.
void add_subject(CLI::App& command, const std::shared_ptr<TradeoffOptions>& options) {
  command.add_option("--of", options->output, "which output (inverse_dynamics)")
      ->type_name("OUTPUT");
  command
      .add_option("--dimensions", options->dimensions,
                  "tried beside the usual ones: form, contraction, order, drop_below, long_double")
      ->type_name("LIST")
      ->delimiter(',')
      ->allow_extra_args(false);
  add_sources(command, "--range", "NAME=LOW..HIGH", options->ranges,
              "where errors are looked at: theta=-0.1..0.1");
}

}  // namespace

void add_tradeoff(CLI::App& app, Action& action) {
  CLI::App* command = app.add_subcommand("tradeoff", "measure speed against accuracy");
  const auto options = std::make_shared<TradeoffOptions>();
  command->add_option("input", options->input, "NAME.toml, NAME.scene.toml or - (stdin)")
      ->required();
  add_subject(*command, options);
  const auto number = [command](const char* name, std::optional<double>& value, const char* doc) {
    return command->add_option_function<double>(
        name, [&value](double given) { value = given; }, doc);
  };
  CLI::Option* const max_error =
      number("--max-error", options->max_error,
             "name the cheapest design whose worst error is at most this");
  CLI::Option* const scene =
      command->add_option("--write-scene", options->scene_file, "write that design as a scene")
          ->type_name("FILE")
          ->needs(max_error);
  CLI::Option* const time = number("--trajectory", options->time,
                                   "runs of so many s by all methods, instead of an output");
  for (const char* name : {"--of", "--dimensions", "--range"}) {
    time->excludes(command->get_option(name));
  }
  time->excludes(scene);
  command->add_option("--format", options->format, "of the table: text, json or csv")
      ->check(CLI::IsMember({"text", "json", "csv"}));
  command->add_option("-o,--output", options->file, "write the table: .svg, .json or .csv")
      ->type_name("FILE");
  command->add_flag("--force", options->force, "overwrite FILE");
  set_action(*command, action, options, &tradeoff_input);
}

}  // namespace elgen::cli
