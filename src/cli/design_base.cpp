// The output is asked for as on a command line.
#include "cli/design_base.hpp"

#include <algorithm>

#include "elgen/wording.hpp"

namespace elgen::cli {

namespace {

/// The output that a table is about where none is named.
std::string default_output(const Scene& scene) {
  const auto is_usual = [](const OutputRequest& output) {
    return output.kind == OutputKind::inverse_dynamics;
  };
  const auto usual = std::ranges::find_if(scene.outputs, is_usual);
  return usual != scene.outputs.end() ? usual->name : scene.outputs.front().name;
}

}  // namespace

Result<OutputBase> output_base(const Inputs& inputs, const std::string& output,
                               const Limits& limits, std::vector<SourcePointer>& sources) {
  PipelineOptions options;
  options.limits = limits;
  options.goals = {Goal::check};
  Diagnostics found;
  std::string name = output;
  if (name.empty()) {
    const Products whole = run_pipeline(inputs, options);
    if (!whole.checked) return whole.diagnostics;
    found = whole.diagnostics;
    name = default_output(whole.checked->scene);
  }
  options.scene.outputs = {sources.emplace_back(make_source("command line", name))};
  Products one = run_pipeline(inputs, options);
  if (!one.checked) return one.diagnostics;
  keep_only(name, one);
  if (one.checked->scene.outputs.empty()) {
    return Diagnostic{Code::E601, {}, in_backticks(name) + " is not one output"};
  }
  OutputBase base{std::move(*one.checked)};
  if (inputs.scene != nullptr) base.scene = parse_scene(inputs.scene, limits).value;
  return {std::move(base), std::move(found)};
}

void keep_only(const std::string& output, Products& products) {
  const auto is_other = [&output](const auto& named) { return named.name != output; };
  std::erase_if(products.checked->scene.outputs, is_other);
  if (!products.program) return;
  Program& program = *products.program;
  std::erase_if(program.functions, is_other);
  std::erase_if(program.readable, is_other);
}

}  // namespace elgen::cli
