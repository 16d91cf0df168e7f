// Computes values at a state, and test vectors, from the text of a model.
#pragma once

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "elgen/pipeline.hpp"
#include "elgen/values.hpp"
#include "support/inputs.hpp"
#include "support/models.hpp"
#include "support/shell.hpp"

namespace elgen::test {

using Json = nlohmann::json;

inline std::vector<SourcePointer> option(const std::string& text) {
  return {make_source("command line", text)};
}

inline SceneOptions options_of(const std::string& state, const std::string& outputs) {
  SceneOptions options;
  options.purpose = purpose::evaluate;
  if (!state.empty()) options.starts = option(state);
  if (!outputs.empty()) options.outputs = option(outputs);
  return options;
}

/// The values at the state of the options `given`, as JSON.
inline Json evaluated(const std::string& text, const SceneOptions& given,
                      const StateOptions& how = {}) {
  const CheckedModel checked = checked_model(text, given);
  const Result<ValueTable> values = state_values(checked, how);
  REQUIRE(values);
  return Json::parse(to_json(*values));
}

/// Derives a model and computes its test vectors.
class Vectors {
 public:
  explicit Vectors(const std::string& text, const TestVectorOptions& options = {},
                   const std::string& outputs = {})
      : products_(derived(text, outputs)),
        table(test_vectors(*products_.checked, *products_.program, options)) {}

 private:
  static Products derived(const std::string& text, const std::string& outputs) {
    PipelineOptions pipeline;
    pipeline.goals = {Goal::choose};
    if (!outputs.empty()) pipeline.scene.outputs = option(outputs);
    return products_with(&Products::program, {make_source("test.toml", text), nullptr}, pipeline);
  }

  Products products_;

 public:
  Result<ValueTable> table;
};

inline const std::string block = read_model("block");

}  // namespace elgen::test
