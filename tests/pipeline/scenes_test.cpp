// What a scene does not need costs nothing: figures of the arm of seven joints.
#include <catch2/catch.hpp>

#include "elgen/pipeline.hpp"
#include "support/shell.hpp"

namespace elgen::test {
namespace {

const std::string root = ELGEN_SOURCE_DIR;

Products products_of(const std::string& outputs, const std::vector<std::string>& fixed) {
  PipelineOptions options;
  options.scene.outputs = {make_source("--outputs", outputs)};
  for (const std::string& name : fixed) options.scene.fixed.push_back(make_source("--fix", name));
  Inputs inputs;
  inputs.model = make_source("panda7.toml", read_text(root + "/models/panda7.toml"));
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
  const Products products = products_of("gravity", {});
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
  const std::size_t symbolic = operations(products_of("inverse_dynamics", {}));
  const std::size_t fixed = operations(products_of("inverse_dynamics", {"all"}));
  INFO(symbolic << " operations, " << fixed << " with numbers");
  CHECK(fixed <= symbolic * 80 / 100);
}

}  // namespace elgen::test
