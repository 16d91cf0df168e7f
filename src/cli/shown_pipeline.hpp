// Functions that run the pipeline for a command: they show the progress, then the diagnostics.
#pragma once

#include <string>
#include <vector>

#include "cli/options.hpp"

namespace elgen::cli {

/// The pipeline options that the global options set. `goals` are used unless --stop-after sets
/// another goal.
[[nodiscard]] PipelineOptions pipeline_options(const GlobalOptions& global,
                                               std::vector<Goal> goals);

/// Runs the pipeline and shows its stages. Clears the line of progress at the end, so that results
/// can be printed.
[[nodiscard]] Products run_pipeline_with_progress(const std::string& subject,
                                                  const PipelineSources& inputs,
                                                  PipelineOptions options);

/// Prints the dump, if any, on stdout and the diagnostics on stderr.
ExitCode report_products(const GlobalOptions& global, const Products& products);

/// True if the model or scene in the file `path` is called `name`, or if errors hide the name.
/// False if the file cannot be read.
[[nodiscard]] bool may_have_name(const GlobalOptions& global, const std::string& path,
                                 const std::string& name);

}  // namespace elgen::cli
