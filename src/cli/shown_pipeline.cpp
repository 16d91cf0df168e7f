#include "cli/shown_pipeline.hpp"

#include <algorithm>
#include <utility>

#include "cli/process/progress.hpp"

namespace elgen::cli {

PipelineOptions pipeline_options(const GlobalOptions& global, std::vector<Goal> goals) {
  PipelineOptions pipeline;
  pipeline.limits = global.limits;
  pipeline.dump = goal_named(global.dump_stage);
  pipeline.goals = std::move(goals);
  if (const auto last = goal_named(global.stop_after)) pipeline.goals = {*last};
  return pipeline;
}

Products run_shown(const std::string& subject, const Inputs& inputs, PipelineOptions options) {
  const Progress progress(subject);
  options.on_stage = [&](const std::string& stage) { progress.stage(stage); };
  return run_pipeline(inputs, options);
}

ExitCode report_products(const GlobalOptions& global, const Products& products) {
  const ExitCode dumped = print(global, products.dump);
  return std::max(dumped, report(global, products.diagnostics));
}

}  // namespace elgen::cli
