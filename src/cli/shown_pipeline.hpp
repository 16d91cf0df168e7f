// The pipeline as all commands run it: progress is shown first, then diagnostics.
#pragma once

#include <string>
#include <vector>

#include "cli/options.hpp"

namespace elgen::cli {

/// The options of all commands, with `goals` unless --stop-after sets another.
[[nodiscard]] PipelineOptions pipeline_options(const GlobalOptions& global,
                                               std::vector<Goal> goals);

/// Runs the pipeline and shows its stages. The line is cleared before this returns, so that
/// products can be printed.
[[nodiscard]] Products run_with_progress(const std::string& subject, const Inputs& inputs,
                                         PipelineOptions options);

/// Prints the dump and the diagnostics.
ExitCode report_products(const GlobalOptions& global, const Products& products);

/// True if the file exists and its scene has this name, or if the name cannot be determined.
[[nodiscard]] bool may_have_name(const GlobalOptions& global, const std::string& path,
                                 const std::string& name);

}  // namespace elgen::cli
