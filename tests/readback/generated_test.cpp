// What the models and scenes of the project are written as is read back as what was derived.
#include <catch2/catch.hpp>
#include <chrono>
#include <filesystem>

#include "written.hpp"

namespace elgen {
namespace {

namespace fs = std::filesystem;

const fs::path models = fs::path(ELGEN_SOURCE_DIR) / "models";

std::vector<fs::path> inputs_in(const fs::path& folder, const std::string& ending) {
  std::vector<fs::path> paths;
  for (const auto& entry : fs::directory_iterator(folder)) {
    if (entry.path().string().ends_with(ending)) paths.push_back(entry.path());
  }
  std::sort(paths.begin(), paths.end());
  return paths;
}

SourcePointer source_of(const fs::path& path) {
  return make_source(path.string(), test::read_text(path));
}

/// The model that the second line of a scene names.
fs::path model_of(const SourcePointer& scene) {
  const std::string_view text = scene->text;
  const std::size_t key = text.find("\nmodel");
  const std::size_t open = text.find('"', key) + 1;
  return models / "scenes" / text.substr(open, text.find('"', open) - open);
}

void expect_read(const Inputs& inputs) {
  PipelineOptions options;
  options.goals = {"readback"};
  const Products products = run_pipeline(inputs, options);
  INFO(inputs.model->path << " " << (inputs.scene ? inputs.scene->path : ""));
  INFO(format(products.diagnostics));
  CHECK_FALSE(has_errors(products.diagnostics));
  REQUIRE(products.readback.has_value());
  CHECK(products.readback->functions >= products.program->functions.size());
}

}  // namespace

TEST_CASE("every model's files are read back") {
  for (const fs::path& path : inputs_in(models, ".toml")) expect_read({source_of(path), nullptr});
}

TEST_CASE("every scene's files are read back") {
  for (const fs::path& path : inputs_in(models / "scenes", ".scene.toml")) {
    const SourcePointer scene = source_of(path);
    expect_read({source_of(model_of(scene)), scene});
  }
}

}  // namespace elgen
