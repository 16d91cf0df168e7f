// The pipeline as every command runs it: its stages are shown while it works, then what it says.
// And what a run in time needs of it.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "cli/options.hpp"
#include "elgen/simulate.hpp"

namespace elgen::cli {

/// Those of every command: `goals`, unless --stop-after names another.
[[nodiscard]] PipelineOptions pipeline_options(const GlobalOptions& global,
                                               std::vector<Goal> goals);

/// run_pipeline with its stages shown. The line is gone when this returns, before anything of the
/// products is printed.
[[nodiscard]] Products run_shown(const std::string& subject, const Inputs& inputs,
                                 PipelineOptions options);

/// Prints the dump and the diagnostics.
ExitCode report_products(const GlobalOptions& global, const Products& products);

/// For a run in time, with the outputs that it calls and the `step` that it goes by, whatever the
/// scene asks for; shown under `path`. E622 where the method is not for the system.
[[nodiscard]] Products derived_for_run(const std::string& path, const Inputs& inputs,
                                       PipelineOptions options,
                                       const std::optional<ChosenStep>& step);

/// Compiled for double, for a run that is not by a program of `step`: in C++, whatever the scene
/// emits. Errors as of `compile`.
[[nodiscard]] Result<CompiledHeaders> compiled_for_run(const Products& products,
                                                       const Limits& limits);

/// Whether a file is there and, for all that is known, still bears the name.
[[nodiscard]] bool may_bear(const GlobalOptions& global, const std::string& path,
                            const std::string& name);

}  // namespace elgen::cli
