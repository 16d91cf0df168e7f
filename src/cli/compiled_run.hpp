// What a run in time needs: the functions of a model or scene, derived, and compiled for double
// where the run is not by a program of `step`.
#pragma once

#include <optional>

#include "cli/options.hpp"
#include "elgen/simulate.hpp"

namespace elgen::cli {

/// With the outputs that a run calls and the `step` that it goes by, whatever the scene asks for;
/// shown under `path`. E622 where the method is not for the system.
[[nodiscard]] Products derived_for_run(const std::string& path, const Inputs& inputs,
                                       PipelineOptions options, std::optional<StepMethod> step);

/// In C++, whatever the scene emits. Errors as of `compile`.
[[nodiscard]] Result<CompiledHeaders> compiled_for_run(const Products& products,
                                                       const Limits& limits);

}  // namespace elgen::cli
