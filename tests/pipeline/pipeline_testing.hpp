// Helpers of the pipeline tests: inputs from models, and runs of generated headers.
#pragma once

#include <catch2/catch.hpp>
#include <string>

#include "elgen/pipeline.hpp"
#include "support/shell.hpp"

namespace elgen::test {

inline std::string model_file(const std::string& name) {
  return read_text(std::string(ELGEN_SOURCE_DIR) + "/models/" + name + ".toml");
}

/// A model, and a scene of it unless `rest` is empty. `rest` follows the scene's name.
inline Inputs inputs_of(const std::string& text, const std::string& rest = {}) {
  Inputs inputs{make_source("model.toml", text)};
  if (!rest.empty()) {
    inputs.scene = make_source("given.scene.toml",
                               "format = 1\nmodel = \"model.toml\"\nname = \"given\"\n" + rest);
  }
  return inputs;
}

/// Runs the pipeline to the goals of `options`. Fails unless there is a program.
inline Products derived(const Inputs& inputs, const PipelineOptions& options = {}) {
  Products products = run_pipeline(inputs, options);
  INFO(format(products.diagnostics));
  REQUIRE(products.program);
  return products;
}

/// Runs the pipeline for these outputs. Fails unless there is a program.
inline Products derived(const Inputs& inputs, const std::string& outputs,
                        const std::vector<Goal>& goals = {Goal::choose}) {
  PipelineOptions options;
  options.scene.outputs = {make_source("--outputs", outputs)};
  options.goals = goals;
  return derived(inputs, options);
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
