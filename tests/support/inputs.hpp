// Makes inputs of the pipeline from texts and files, and runs the pipeline.
#pragma once

#include <catch2/catch.hpp>
#include <filesystem>
#include <optional>

#include "elgen/pipeline.hpp"
#include "support/text.hpp"

namespace elgen::test {

inline SourcePointer source_of(const std::filesystem::path& path) {
  return make_source(path.string(), read_text(path));
}

/// A model, and a scene of it unless `rest` is empty. `rest` follows the scene's name.
inline PipelineSources inputs_of(const std::string& text, const std::string& rest = {}) {
  PipelineSources inputs{make_source("model.toml", text)};
  if (!rest.empty()) {
    inputs.scene = make_source("given.scene.toml",
                               "format = 1\nmodel = \"model.toml\"\nname = \"given\"\n" + rest);
  }
  return inputs;
}

/// Runs the pipeline. Fails the test unless the product exists.
template <class Product>
Products products_with(std::optional<Product> Products::*product, const PipelineSources& inputs,
                       const PipelineOptions& options = {}) {
  Products products = run_pipeline(inputs, options);
  INFO(format(products.diagnostics));
  REQUIRE(products.*product);
  return products;
}

}  // namespace elgen::test
