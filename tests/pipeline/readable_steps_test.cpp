// The derivation as it is read: the steps of every coordinate, and whose positions they start from.
#include "pipeline/readable_steps.hpp"

#include <algorithm>
#include <catch2/catch.hpp>

#include "elgen/pipeline.hpp"
#include "support/shell.hpp"

namespace elgen {

TEST_CASE("dL/dq and d/dt dL/dv are steps of their own") {
  PipelineOptions options;
  options.goals = {Goal::steps};
  const std::string path = std::string(ELGEN_SOURCE_DIR) + "/models/simple_pendulum.toml";
  const Products products =
      run_pipeline({make_source("simple_pendulum.toml", test::read_text(path)), nullptr}, options);
  REQUIRE(products.steps);
  const Program& program = products.steps->program;
  const auto is_theta = [](const Function& function) { return function.name == "theta"; };
  const auto theta = std::find_if(program.functions.begin(), program.functions.end(), is_theta);
  REQUIRE(theta != program.functions.end());
  const FunctionEquations steps =
      readable_equations(program, static_cast<std::size_t>(theta - program.functions.begin()));
  const std::vector<std::vector<std::string>> expected{{"m*l^2*dot(theta)"},
                                                       {"m*l^2*dot(dot(theta))"},
                                                       {"-m*l*g*sin(theta)"},
                                                       {"0"},
                                                       {"0"},
                                                       {"m*l*(l*dot(dot(theta)) + g*sin(theta))"}};
  CHECK(steps.entries == expected);
  CHECK(products.steps->masses == std::vector<std::string>{"bob"});
}

}  // namespace elgen
