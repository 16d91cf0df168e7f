// What a scene does not need costs nothing: figures of the arm of seven joints.
#include <catch2/catch.hpp>

#include "elgen/pipeline.hpp"
#include "pipeline/pipeline_testing.hpp"

namespace elgen::test {
namespace {

Products fixed_products(const std::string& outputs, const std::vector<std::string>& fixed) {
  PipelineOptions options;
  options.scene.outputs = {make_source("--outputs", outputs)};
  for (const std::string& name : fixed) options.scene.fixed.push_back(make_source("--fix", name));
  Inputs inputs;
  inputs.model = make_source("panda7.toml", model_file("panda7"));
  Products products = run_pipeline(inputs, options);
  INFO(format(products.diagnostics));
  REQUIRE(products.program);
  return products;
}

std::size_t operations(const Products& products) {
  const OperationCounts counts = count_operations(products.program->functions.front());
  return counts.add + counts.mul + counts.div;
}

}  // namespace

TEST_CASE("gravity alone has no velocities", "[scenes]") {
  const Products products = fixed_products("gravity", {});
  CHECK(operations(products) <= 250);
  CHECK(dump(*products.program).find("velocity") == std::string::npos);
  for (const auto& [path, text] : products.files->files) {
    if (path.substr(path.rfind('.')) != ".hpp") continue;
    const std::size_t body = text.find("gravity(");
    REQUIRE(body != std::string::npos);
    CHECK(text.find("Velocities<Scalar>&", body) == std::string::npos);
  }
}

TEST_CASE("fixed parameters save a fifth of the inverse dynamics", "[scenes]") {
  const std::size_t symbolic = operations(fixed_products("inverse_dynamics", {}));
  const std::size_t fixed = operations(fixed_products("inverse_dynamics", {"all"}));
  INFO(symbolic << " operations, " << fixed << " with numbers");
  CHECK(fixed <= symbolic * 80 / 100);
}

}  // namespace elgen::test
