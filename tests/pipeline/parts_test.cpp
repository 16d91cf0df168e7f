// What solutions are judged by is picked where the scene has it, and derived where not.
#include "pipeline/parts.hpp"

#include <catch2/catch.hpp>

#include "elgen/pipeline.hpp"
#include "support/shell.hpp"

namespace elgen {

namespace {

/// The parts for one output of the cart and pole.
Products with_parts(const std::string& output) {
  const std::string path = std::string(ELGEN_SOURCE_DIR) + "/models/cart_pole.toml";
  PipelineOptions options;
  options.scene.outputs = {make_source("--outputs", output)};
  options.goals = {Goal::choose, Goal::parts};
  return run_pipeline({make_source("cart_pole.toml", test::read_text(path)), nullptr}, options);
}

std::vector<OutputKind> kinds(const Products& products) {
  std::vector<OutputKind> result;
  for (const Function& function : products.parts.functions) result.push_back(function.kind);
  return result;
}

const std::vector<OutputKind> of_accelerations{OutputKind::mass_matrix, OutputKind::bias,
                                               OutputKind::input_matrix};

}  // namespace

TEST_CASE("parts are derived where the scene lacks one, and picked where it has all") {
  const Products lacking = with_parts("forward_dynamics");
  CHECK(kinds(lacking) == of_accelerations);
  CHECK(known_parts(*lacking.checked, *lacking.program).functions.empty());

  const Products having = with_parts("mass_matrix, bias, input_matrix, forward_dynamics");
  CHECK(kinds(having) == of_accelerations);
  CHECK(known_parts(*having.checked, *having.program).functions.size() == 3);
}

TEST_CASE("nothing solved has no parts") {
  const Products products = with_parts("inverse_dynamics");
  CHECK_FALSE(has_errors(products.diagnostics));
  CHECK(products.parts.functions.empty());
}

}  // namespace elgen
