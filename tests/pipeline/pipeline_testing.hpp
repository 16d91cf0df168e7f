// Helpers of the pipeline tests: inputs from models, and runs of generated headers.
#pragma once

#include <catch2/catch.hpp>
#include <string>

#include "elgen/pipeline.hpp"
#include "support/inputs.hpp"
#include "support/shell.hpp"

namespace elgen::test {

/// Runs the pipeline to the goals of `options`. Fails unless there is a program.
inline Products derived(const PipelineSources& inputs, const PipelineOptions& options = {}) {
  return products_with(&Products::program, inputs, options);
}

/// Runs the pipeline for these outputs. Fails unless there is a program.
inline Products derived(const PipelineSources& inputs, const std::string& outputs,
                        const std::vector<Goal>& goals = {Goal::choose}) {
  return derived(inputs,
                 {.scene = {.outputs = {make_source("--outputs", outputs)}}, .goals = goals});
}

inline std::size_t operations(const Function& function) {
  const OperationCounts counts = count_operations(function);
  return counts.add + counts.mul + counts.div;
}

/// The output of a program that includes headers of the folder or of generated/.
inline std::string printed(const Workspace& folder, const std::string& program) {
  folder.write("main.cpp", program);
  const std::string include = std::string(ELGEN_SOURCE_DIR) + "/generated";
  folder.prepare("c++ -std=c++17 -O1 -I. -I'" + include + "' main.cpp -o main");
  return folder.run("./main").output;
}

}  // namespace elgen::test
