// elgen evaluate: the oracle's values of the outputs of a model or scene at one state.
#include <algorithm>
#include <array>

#include "cli/commands.hpp"
#include "cli/files/data_formats.hpp"
#include "cli/files/inputs.hpp"
#include "cli/shown_pipeline.hpp"
#include "elgen/values.hpp"

namespace elgen::cli {

namespace {

struct EvaluateOptions {
  std::string input = {};
  SceneOptions scene = {};
  StateOptions values = {};
  std::string format = {};  ///< format on stdout; empty: follows --format
};

constexpr std::array value_formats{DataFormat<ValueTable>{"csv", &to_csv},
                                   DataFormat<ValueTable>{"json", &to_json},
                                   DataFormat<ValueTable>{"text", &to_text}};

ExitCode evaluate_input(const GlobalOptions& global, const EvaluateOptions& options) {
  const Result<PipelineSources> inputs = read_inputs(options.input, global.limits);
  if (!inputs) return report(global, inputs.diagnostics);
  PipelineOptions pipeline = pipeline_options(global, {Goal::check});
  pipeline.scene = options.scene;
  pipeline.scene.purpose = purpose::evaluate;
  const Products products = run_pipeline_with_progress(options.input, *inputs, pipeline);
  const ExitCode checked = report_products(global, products);
  print_stage_times(global, products);
  if (checked != ExitCode::success || !global.stop_after.empty()) return checked;
  const Result<ValueTable> values = state_values(*products.checked, options.values);
  const ExitCode found = report(global, values.diagnostics);
  if (!values) return found;
  const std::string usual = wants_json(global) ? "json" : "text";
  const std::string& as = options.format.empty() ? usual : options.format;
  const auto format = select_format<ValueTable>("." + as, value_formats);
  return std::max(found, print(global, format->text(*values)));
}

}  // namespace

void add_evaluate(CLI::App& app, Action& action) {
  CLI::App* command = app.add_subcommand("evaluate", "print the values of outputs at a state");
  const auto options = std::make_shared<EvaluateOptions>();
  command->add_option("input", options->input, "NAME.toml, NAME.scene.toml or - (stdin)")
      ->required();
  add_source_option(*command, "--what", "LIST", options->scene.outputs,
                    "outputs: mass_matrix,gravity,… (default: all outputs of the scene)");
  add_source_option(*command, "--state", "NAME=VALUE,…", options->scene.starts,
                    "state: theta=1, dot(theta)=0, dot(dot(theta))=2, p(theta)=1, t=0, h=0.01, "
                    "attitude=[1,0,0,0] (default: the start)");
  add_source_option(*command, "--set", "NAME=VALUE", options->scene.values, "value of a parameter");
  add_source_option(*command, "--input", "NAME=LAW", options->scene.laws,
                    "value or law of an input: u=-3*theta - dot(theta)");
  command
      ->add_option("--digits", options->values.digits,
                   "significant digits, at most 60 (default: 17)")
      ->check(CLI::Range(1, max_value_digits));
  command
      ->add_option_function<std::string>(
          "--project",
          [options = options.get()](const std::string& given) {
            options->values.projects = given == "on";
          },
          "project values that --state does not name onto the constraints (default: on)")
      ->check(CLI::IsMember({"on", "off"}));
  command->add_option("--as", options->format, "text (default), json or csv")
      ->check(CLI::IsMember({"text", "json", "csv"}));
  add_specialisation_options(*command, options->scene);
  set_action(*command, action, options, &evaluate_input);
}

}  // namespace elgen::cli
