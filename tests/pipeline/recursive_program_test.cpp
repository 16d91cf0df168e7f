// Equations of one's own are those of the stages, and their limits hold.
#include "pipeline/recursive_program.hpp"

#include <catch2/catch.hpp>

#include "elgen/pipeline.hpp"
#include "pipeline/pipeline_testing.hpp"

namespace elgen {

namespace {

Inputs cart_pole_inputs() {
  return {make_source("cart_pole.toml", test::model_file("cart_pole")), nullptr};
}

CheckedModel checked() {
  PipelineOptions options;
  options.goals = {Goal::check};
  return *run_pipeline(cart_pole_inputs(), options).checked;
}

}  // namespace

TEST_CASE("what is derived beside the stages is what they derive") {
  const CheckedModel model = checked();
  const Result<Lagrangian> lagrangian = formulate(model.model);
  REQUIRE(lagrangian);
  const Result<Program> program = recursive_program(*lagrangian, model.scene.outputs, {});
  REQUIRE(program);
  PipelineOptions options;
  options.goals = {Goal::cancel};
  options.dump = Goal::cancel;
  CHECK(dump(*program) == run_pipeline(cart_pole_inputs(), options).dump);
}

TEST_CASE("a limit on derived nodes ends it") {
  const CheckedModel model = checked();
  const Result<Lagrangian> lagrangian = formulate(model.model);
  Limits limits;
  limits.derived_nodes = 3;
  const Result<Program> program = recursive_program(*lagrangian, model.scene.outputs, limits);
  CHECK_FALSE(program);
  REQUIRE(program.diagnostics.size() == 1);
  CHECK(program.diagnostics.front().code == Code::E908);
}

}  // namespace elgen
