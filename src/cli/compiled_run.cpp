// The model is checked once before, to know which outputs it has.
#include "cli/compiled_run.hpp"

#include "cli/shown_pipeline.hpp"

namespace elgen::cli {

Products derived_for_run(const std::string& path, const Inputs& inputs, PipelineOptions options,
                         std::optional<StepMethod> step) {
  PipelineOptions first = options;
  first.goals = {Goal::check};
  Products checked = run_pipeline(inputs, first);
  if (!checked.checked) return checked;
  const std::string outputs = outputs_of_run(checked.checked->model);
  options.scene.outputs = {make_source("outputs of a run", outputs)};
  options.scene.step = step;
  return run_shown(path, inputs, std::move(options));
}

Result<CompiledHeaders> compiled_for_run(const Products& products, const Limits& limits) {
  const auto& [model, scene] = *products.checked;
  Scene plain = scene;
  plain.emission = {.name_space = scene.emission.name_space};
  plain.numerics = {};
  const Result<EmittedFiles> files = emit(model, plain, *products.program);
  if (!files) return files.diagnostics;
  return compile(*files, model, plain, *products.program, {limits});
}

}  // namespace elgen::cli
