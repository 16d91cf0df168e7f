// Helpers of the tests of analysis: find equilibria of models and print pages.
#pragma once

#include <catch2/catch.hpp>
#include <string>
#include <vector>

#include "pipeline/pipeline_testing.hpp"

namespace elgen::test {

struct Analysed {
  CheckedModel checked;
  Equilibria equilibria;
};

/// Options of a scene as on the command line, such as "Omega=7".
struct AnalysisOptions {
  std::vector<std::string> fixed = {};
  std::vector<std::string> laws = {};
  std::vector<std::string> sizes = {};
  std::uint64_t boxes = Limits{}.boxes;
};

inline Products analysed_products(const std::string& text, const AnalysisOptions& words = {}) {
  PipelineOptions options;
  options.goals = {Goal::equilibria};
  options.limits.boxes = words.boxes;
  for (const std::string& word : words.fixed) {
    options.scene.fixed.push_back(make_source("--fix", word));
  }
  for (const std::string& word : words.laws) {
    options.scene.laws.push_back(make_source("--input", word));
  }
  for (const std::string& word : words.sizes) {
    options.scene.sizes.push_back(make_source("--size", word));
  }
  return run_pipeline(inputs_of(text), options);
}

inline Analysed analyse_model(const std::string& text, const AnalysisOptions& words = {}) {
  Products products = analysed_products(text, words);
  INFO(format(products.diagnostics));
  REQUIRE(products.equilibria);
  return {std::move(*products.checked), std::move(*products.equilibria)};
}

/// The normal modes about the state `at`, or about all stable equilibria if `at` is empty.
inline Products modes_products(const PipelineSources& inputs, const std::string& at = {},
                               const std::vector<std::string>& sizes = {}) {
  PipelineOptions options;
  options.goals = {Goal::modes};
  if (!at.empty()) options.scene.starts = {make_source("--at", at)};
  if (!at.empty()) options.equilibrium_name = "";
  for (const std::string& size : sizes) options.scene.sizes.push_back(make_source("--size", size));
  return run_pipeline(inputs, options);
}

/// A model with V = `potential`. `coordinates` are [[coordinate]] tables of armature 1.
inline std::string potential_model(const std::string& coordinates, const std::string& potential) {
  return "format = 1\n[model]\nname = \"drawn\"\n" + coordinates + "[energy]\nV = \"" + potential +
         "\"\n";
}

inline std::string coordinate(const std::string& name, const std::string& range = {}) {
  return "[[coordinate]]\nname = \"" + name + "\"\narmature = 1\n" +
         (range.empty() ? "" : "range = " + range + "\n");
}

}  // namespace elgen::test
