// elgen vectors: states and what functions give there, for tests of code that others wrote.
#include <array>

#include "cli/commands.hpp"
#include "cli/files/data_formats.hpp"
#include "cli/files/inputs.hpp"
#include "cli/files/output_files.hpp"
#include "cli/process/progress.hpp"
#include "cli/process/resources.hpp"
#include "cli/shown_pipeline.hpp"
#include "elgen/values.hpp"

namespace elgen::cli {

namespace {

struct VectorsOptions {
  std::string input = {};
  SceneOptions scene = {};
  VectorOptions vectors = {};
  std::string file = {};  ///< empty: JSON is printed
  bool force = false;
};

constexpr std::array vector_formats{DataFormat<ValueTable>{"csv", &to_csv},
                                    DataFormat<ValueTable>{"json", &to_json},
                                    DataFormat<ValueTable>{"h", &to_header}};

/// The stages are shown; their line is gone when this returns.
Result<ValueTable> vectors_of(const GlobalOptions& global, const VectorsOptions& options,
                              const Products& products) {
  const Progress progress(options.input);
  progress.stage("vectors");
  renew_time_limit(global.limits);
  return test_vectors(*products.checked, *products.program, options.vectors);
}

ExitCode make_vectors(const GlobalOptions& global, const VectorsOptions& options) {
  const std::string file = options.file.empty() ? ".json" : options.file;
  const auto format = format_of<ValueTable>(file, vector_formats);
  if (!format) return report(global, format.diagnostics);
  std::vector<OutputFile> files;
  if (!options.file.empty()) files.push_back({options.file, "", Replaces::nothing});
  const Diagnostics refused = refuse_places(files, options.force);
  if (!refused.empty()) return report(global, refused);
  const Result<Inputs> inputs = read_inputs(options.input, global.limits);
  if (!inputs) return report(global, inputs.diagnostics);
  PipelineOptions pipeline = pipeline_options(global, {Goal::choose});
  pipeline.scene = options.scene;
  const Products products = run_shown(options.input, *inputs, pipeline);
  const ExitCode derived = report_products(global, products);
  tell_times(global, products);
  if (derived != ExitCode::success || !global.stop_after.empty()) return derived;
  const Result<ValueTable> vectors = vectors_of(global, options, products);
  if (!vectors) return report(global, vectors.diagnostics);
  const std::string text = format->text(*vectors);
  if (files.empty()) return print(global, text);
  files.front().text = text;
  return report(global, write_files(files, {options.force, global.limits.seconds}).diagnostics);
}

}  // namespace

void add_vectors(CLI::App& app, Action& action) {
  CLI::App* command = app.add_subcommand("vectors", "states and values, to test other code by");
  const auto options = std::make_shared<VectorsOptions>();
  command->add_option("input", options->input, "NAME.toml, NAME.scene.toml or - (stdin)")
      ->required();
  add_sources(*command, "--outputs", "LIST", options->scene.outputs,
              "of these outputs: mass_matrix,forward_dynamics (those of the scene)");
  command->add_option("--samples", options->vectors.samples, "states of each output (16)")
      ->check(refused_number)
      ->check(CLI::PositiveNumber);
  command->add_option("--seed", options->vectors.seed, "of the states (1)")->check(refused_number);
  command->add_option("-o,--output", options->file, "write .json, .csv or .h (JSON on stdout)")
      ->type_name("FILE");
  command->add_flag("--force", options->force, "overwrite FILE");
  add_specialisation(*command, options->scene);
  set_action(*command, action, options, &make_vectors);
}

}  // namespace elgen::cli
