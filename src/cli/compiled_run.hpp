// What a run in time needs: the functions of a model or scene, derived, and compiled for double.
#pragma once

#include "cli/options.hpp"
#include "elgen/simulate.hpp"

namespace elgen::cli {

/// With the outputs that a run calls, whatever the scene asks for; shown under `path`.
[[nodiscard]] Products derived_for_run(const std::string& path, const Inputs& inputs,
                                       PipelineOptions options);

/// In C++, whatever the scene emits. Errors as of `compile`.
[[nodiscard]] Result<CompiledHeaders> compiled_for_run(const Products& products,
                                                       const Limits& limits);

}  // namespace elgen::cli
