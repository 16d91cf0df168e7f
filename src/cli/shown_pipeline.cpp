// Runs the pipeline, and shows its stages on one line of the terminal.
#include "cli/shown_pipeline.hpp"

#include <algorithm>
#include <filesystem>
#include <utility>

#include "cli/files/inputs.hpp"
#include "cli/process/resources.hpp"
#include "cli/process/terminal.hpp"

namespace elgen::cli {

PipelineOptions pipeline_options(const GlobalOptions& global, std::vector<Goal> goals) {
  PipelineOptions pipeline;
  pipeline.limits = global.limits;
  pipeline.dump = find_stage(global.dump_stage);
  pipeline.goals = std::move(goals);
  if (const auto last = find_stage(global.stop_after)) pipeline.goals = {*last};
  return pipeline;
}

Products run_pipeline_with_progress(const std::string& subject, const PipelineSources& inputs,
                                    PipelineOptions options) {
  const Progress progress(subject);
  options.on_stage = [&](const std::string& stage) { progress.show_stage(stage); };
  return run_pipeline(inputs, options);
}

ExitCode report_products(const GlobalOptions& global, const Products& products) {
  const ExitCode dumped = print(global, products.dump);
  return std::max(dumped, report(global, products.diagnostics));
}

bool may_have_name(const GlobalOptions& global, const std::string& path, const std::string& name) {
  std::error_code error;
  if (!std::filesystem::is_regular_file(path, error)) return false;
  const Result<PipelineSources> inputs = read_inputs(path, global.limits);
  if (!inputs) return false;
  renew_time_limit(global.limits);
  const Products products = run_pipeline(*inputs, pipeline_options(global, {Goal::check}));
  return !products.checked || products.checked->scene.base_name == name;
}

}  // namespace elgen::cli
