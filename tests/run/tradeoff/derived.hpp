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
/// name; `ranges` and `over` are the arguments of --range and --over.
inline Products derived(const std::string& text, const std::string& output,
                        const std::string& scene = {},
                        const std::vector<SourcePointer>& ranges = {},
                        const std::vector<SourcePointer>& over = {}) {
  PipelineOptions options;
  options.goals = {Goal::choose};
  options.scene.outputs = {make_source("command line", output)};
  options.scene.ranges = ranges;
  options.scene.over = over;
  Products products = run_pipeline(inputs_of(text, scene), options);
  if (!products.program) throw std::runtime_error(format(products.diagnostics));
  return products;
}

}  // namespace elgen::test
