// elgen vectors: writes states, and the values of functions at these states, as tests for other
// code.
#include <array>

#include "cli/commands.hpp"
#include "cli/files/data_formats.hpp"
#include "cli/files/inputs.hpp"
#include "cli/process/resources.hpp"
#include "cli/process/terminal.hpp"
#include "cli/shown_pipeline.hpp"
#include "elgen/values.hpp"

namespace elgen::cli {

namespace {

struct VectorsOptions {
  std::string input = {};
  SceneOptions scene = {};
  TestVectorOptions vectors = {};
  FileOption output = {};  ///< empty: JSON on stdout
};

constexpr std::array vector_formats{DataFormat<ValueTable>{"csv", &to_csv},
                                    DataFormat<ValueTable>{"json", &to_json},
                                    DataFormat<ValueTable>{"h", &to_header}};

/// Computes the vectors and shows the stage. The line of progress is cleared before this returns.
Result<ValueTable> compute_vectors(const GlobalOptions& global, const VectorsOptions& options,
                                   const Products& products) {
  const Progress progress(options.input);
  renew_time_limit(global.limits);
  TestVectorOptions vectors = options.vectors;
  vectors.on_step = [&progress](const std::string& step) { progress.show_stage(step); };
  return test_vectors(*products.checked, *products.program, vectors);
}

ExitCode make_vectors(const GlobalOptions& global, const VectorsOptions& options) {
  const bool is_printed = options.output.file.empty();
  const std::string file = is_printed ? ".json" : options.output.file;
  const auto format = select_format<ValueTable>(file, vector_formats);
  if (!format) return report(global, format.diagnostics);
  const Diagnostics refused = check_output_path(options.output);
  if (!refused.empty()) return report(global, refused);
  const Result<PipelineSources> inputs = read_inputs(options.input, global.limits);
  if (!inputs) return report(global, inputs.diagnostics);
  PipelineOptions pipeline = pipeline_options(global, {Goal::choose});
  pipeline.scene = options.scene;
  const Products products = run_pipeline_with_progress(options.input, *inputs, pipeline);
  const ExitCode derived = report_products(global, products);
  print_stage_times(global, products);
  if (derived != ExitCode::success || !global.stop_after.empty()) return derived;
  const Result<ValueTable> vectors = compute_vectors(global, options, products);
  if (!vectors) return report(global, vectors.diagnostics);
  const std::string text = format->text(*vectors);
  if (is_printed) return print(global, text);
  return report(global, write_output(global, options.output, text).diagnostics);
}

}  // namespace

void add_vectors(CLI::App& app, Action& action) {
  CLI::App* command =
      app.add_subcommand("vectors", "write states and values for tests of other code");
  const auto options = std::make_shared<VectorsOptions>();
  command->add_option("input", options->input, "NAME.toml, NAME.scene.toml or - (stdin)")
      ->required();
  add_source_option(*command, "--outputs", "LIST", options->scene.outputs,
                    "outputs: mass_matrix,forward_dynamics (default: all outputs of the scene)");
  command->add_option("--samples", options->vectors.samples, "states per output (default: 16)")
      ->check(number_error)
      ->check(CLI::PositiveNumber);
  command->add_option("--seed", options->vectors.seed, "seed of the random states (default: 1)")
      ->check(number_error);
  add_file_options(*command, options->output, "write .json, .csv or .h (default: JSON on stdout)");
  add_specialisation_options(*command, options->scene);
  set_action(*command, action, options, &make_vectors);
}

}  // namespace elgen::cli
