// elgen tradeoff: the designs of one output, or runs, measured, as a table.
#include "elgen/tradeoff.hpp"

#include <algorithm>

#include "cli/commands.hpp"
#include "cli/designs.hpp"
#include "cli/files/inputs.hpp"
#include "cli/runs.hpp"
#include "cli/tradeoff_output.hpp"

namespace elgen::cli {

namespace {

struct TradeoffOptions {
  std::string input = {};
  std::string of = {};              ///< which output
  std::optional<double> time = {};  ///< of runs, in the place of an output
  std::vector<std::string> dimensions = {};
  std::vector<SourcePointer> ranges = {};
  TradeoffOutput output = {};
};

/// A table, and the exit code of what was said of it.
struct MeasuredHere {
  ExitCode found = ExitCode::success;
  std::optional<TradeoffTable> table = {};
};

MeasuredHere measure_designs(const GlobalOptions& global, const TradeoffOptions& options,
                             const Inputs& inputs) {
  std::vector<SourcePointer> sources;
  const Result<MeasuredDesigns> measured =
      measured_designs({options.input, inputs, options.of, options.dimensions, options.ranges},
                       global.limits, sources);
  const ExitCode found = report(global, measured.diagnostics);
  if (!measured) return {found};
  if (measured->not_compiled.empty()) return {found, measured->table};
  // The others are measured all the same, so it is no mistake of elgen's alone.
  report(global, measured->not_compiled);
  return {ExitCode::inaccessible, measured->table};
}

MeasuredHere measure_runs(const GlobalOptions& global, const TradeoffOptions& options,
                          const Inputs& inputs) {
  const Result<TradeoffTable> table =
      measured_runs({options.input, inputs, *options.time}, global.limits);
  const ExitCode found = report(global, table.diagnostics);
  return table ? MeasuredHere{found, *table} : MeasuredHere{found};
}

/// A scene names the file of its model.
Diagnostics refuse_scene(const TradeoffOptions& options, const Inputs& inputs) {
  if (options.output.scene_file.empty() || inputs.model->path != stdin_name) return {};
  return {{Code::E913, {}, "a scene cannot name a model on standard input"}};
}

ExitCode measure_input(const GlobalOptions& global, const TradeoffOptions& options) {
  const Result<Inputs> inputs = read_inputs(options.input, global.limits);
  if (!inputs) return report(global, inputs.diagnostics);
  const Diagnostics refused = refuse_scene(options, *inputs);
  if (!refused.empty()) return report(global, refused);
  const auto measure = options.time ? measure_runs : measure_designs;
  const auto [found, table] = measure(global, options, *inputs);
  if (!table) return found;
  return std::max(found, deliver(global, options.output, *inputs, judged(*table)));
}

ExitCode run_tradeoff(const GlobalOptions& global, const TradeoffOptions& options) {
  const Diagnostics wrong = refuse_output(options.output);
  return wrong.empty() ? measure_input(global, options) : report(global, wrong);
}

CLI::Option* add_number(CLI::App& command, const char* name, std::optional<double>& value,
                        const char* doc) {
  return command.add_option_function<double>(
      name, [&value](double given) { value = given; }, doc);
}

/// Of what designs there are, and where they are looked at; or of which runs.
void add_subject(CLI::App& command, TradeoffOptions& options) {
  CLI::Option* const time = add_number(command, "--trajectory", options.time,
                                       "runs of so many s by all methods, instead of an output");
  command.add_option("--of", options.of, "which output (inverse_dynamics)")
      ->type_name("OUTPUT")
      ->excludes(time);
  command
      .add_option("--dimensions", options.dimensions,
                  "tried beside the usual ones: order, of an expansion about the start")
      ->type_name("LIST")
      ->delimiter(',')
      ->allow_extra_args(false)
      ->excludes(time);
  add_sources(command, "--range", "NAME=LOW..HIGH", options.ranges,
              "where errors are looked at: theta=-0.1..0.1");
  command.get_option("--range")->excludes(time);
}

/// What becomes of the table.
void add_output(CLI::App& command, TradeoffOutput& output) {
  CLI::Option* const max_error =
      add_number(command, "--max-error", output.max_error,
                 "name the cheapest design whose worst error is at most this");
  command.add_option("--write-scene", output.scene_file, "write that design as a scene")
      ->type_name("FILE")
      ->needs(max_error)
      ->excludes(command.get_option("--trajectory"));
  command.add_option("--as", output.as, "of the table: text (unless given), json or csv")
      ->check(CLI::IsMember({"text", "json", "csv"}));
  command.add_option("-o,--output", output.file, "write the table (.svg, .json or .csv)")
      ->type_name("FILE");
  command.add_flag("--force", output.force, "overwrite FILE");
}

}  // namespace

void add_tradeoff(CLI::App& app, Action& action) {
  CLI::App* command = app.add_subcommand("tradeoff", "measure speed against accuracy");
  const auto options = std::make_shared<TradeoffOptions>();
  command->add_option("input", options->input, "NAME.toml, NAME.scene.toml or - (stdin)")
      ->required();
  add_subject(*command, *options);
  add_output(*command, options->output);
  set_action(*command, action, options, &run_tradeoff);
}

}  // namespace elgen::cli
