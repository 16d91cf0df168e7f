// What generation costs, output by output, and what a scene saves against its full model.
#pragma once

#include <string>

#include "elgen/pipeline.hpp"

namespace elgen::cli {

/// A table: for every output the cost of one call, that of the same output of the full model, and
/// the time to derive the output alone (formulate to choose). `products` are those of `inputs`;
/// every output is derived once more, and the full model where there is a scene.
[[nodiscard]] std::string generation_costs(const Inputs& inputs, const PipelineOptions& options,
                                           const Products& products);

}  // namespace elgen::cli
