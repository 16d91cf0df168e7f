// The step of a scene stands behind what was chosen, and costs what it executes.
#include "pipeline/chosen.hpp"

#include <catch2/catch.hpp>

#include "elgen/pipeline.hpp"
#include "support/shell.hpp"

namespace elgen {

namespace {

Products with_outputs(const std::string& outputs) {
  const std::string path = std::string(ELGEN_SOURCE_DIR) + "/models/cart_pole.toml";
  const std::string scene =
      "format = 1\nmodel = \"cart_pole.toml\"\nname = \"next\"\n[outputs]\n" + outputs;
  PipelineOptions options;
  options.goals = {Goal::self_check};
  return run_pipeline(
      {make_source("cart_pole.toml", test::read_text(path)), make_source("next.scene.toml", scene)},
      options);
}

}  // namespace

TEST_CASE("a step is the last function, with a cost and without closed forms") {
  const Products products =
      with_outputs("step = { method = \"rk4\" }\nmass_matrix = true\ndynamics = true\n");
  INFO(format(products.diagnostics));
  REQUIRE(products.self_check);
  const Program& program = *products.program;
  REQUIRE(program.functions.size() == 3);
  CHECK(program.functions.back().kind == OutputKind::step);
  CHECK(program.readable.size() == 3);
  CHECK(program.readable.back().fields.empty());
  REQUIRE(products.costs.size() == 3);
  CHECK(products.costs.back().function == "step");
  CHECK(products.costs.back().recursive == count_operations(program.functions.back()));
}

TEST_CASE("a step alone needs no other output") {
  const Products products = with_outputs("step = { method = \"rk4\" }\n");
  INFO(format(products.diagnostics));
  CHECK(products.self_check);
  CHECK(products.program->functions.size() == 1);
}

TEST_CASE("a method that does not apply ends the pipeline before anything is emitted") {
  const Products products = with_outputs("step = { method = \"verlet\" }\n");
  CHECK_FALSE(products.files);
  REQUIRE_FALSE(products.diagnostics.empty());
  CHECK(products.diagnostics.front().code == Code::E622);
}

}  // namespace elgen
