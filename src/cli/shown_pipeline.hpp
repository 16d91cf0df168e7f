// The pipeline as every command runs it: its stages are shown while it works, then what it says.
#pragma once

#include <string>
#include <vector>

#include "cli/options.hpp"

namespace elgen::cli {

/// Options that all commands have: `goals`, unless --stop-after names another.
[[nodiscard]] PipelineOptions pipeline_options(const GlobalOptions& global,
                                               std::vector<Goal> goals);

/// run_pipeline with its stages shown. The line is gone when this returns, before anything of the
/// products is printed.
[[nodiscard]] Products run_shown(const std::string& subject, const Inputs& inputs,
                                 PipelineOptions options);

/// Prints the dump and the diagnostics.
ExitCode report_products(const GlobalOptions& global, const Products& products);

/// Whether a file is there and, for all that is known, still bears the name.
[[nodiscard]] bool may_bear(const GlobalOptions& global, const std::string& path,
                            const std::string& name);

}  // namespace elgen::cli
