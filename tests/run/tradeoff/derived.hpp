// Derived products for tests of trade-offs, from model texts.
#pragma once

#include <stdexcept>
#include <string>
#include <vector>

#include "elgen/pipeline.hpp"
#include "elgen/tradeoff.hpp"
#include "support/inputs.hpp"
#include "support/models.hpp"

namespace elgen::test {

/// Derives one output of the model; throws the diagnostics on failure. `scene` follows the scene's
/// name, `ranges` are the arguments of --range.
inline Products derived(const std::string& text, const std::string& output,
                        const std::string& scene = {},
                        const std::vector<SourcePointer>& ranges = {}) {
  PipelineOptions options;
  options.goals = {Goal::choose};
  options.scene.outputs = {make_source("command line", output)};
  options.scene.ranges = ranges;
  Products products = run_pipeline(inputs_of(text, scene), options);
  if (!products.program) throw std::runtime_error(format(products.diagnostics));
  return products;
}

/// m l^2 a + m g l sin q + k t q
inline std::string pendulum_text() {
  return model_text("pendulum", R"toml([[coordinate]]
name = "q"
unit = "rad"
start = { value = "1/2", rate = 0 }
[parameters]
m = 2
l = "sqrt(2)"
g = 9.81
k = 1
[energy]
T = "1/2*m*l^2*dot(q)^2"
V = "-m*g*l*cos(q)"
[[force]]
name = "push"
on = "q"
value = "-k*t*q"
)toml");
}

}  // namespace elgen::test
