// loaded_version: equations are lowered, which is enough to compare them; forms are chosen where
// what is emitted is not what is lowered, and where that takes little.
#include "cli/versions/loaded_version.hpp"

#include <algorithm>

#include "cli/process/resources.hpp"

namespace elgen::cli {

namespace {

/// So many instructions take about as long in their forms as without them; panda7 has 29 000.
constexpr std::size_t most_chosen = 2'000;

/// Steps are made of functions in their forms.
bool needs_forms(const Scene& scene) {
  return std::ranges::any_of(
      scene.outputs, [](const OutputRequest& output) { return output_row(output.kind).steps; });
}

bool is_small(const Program& program) {
  std::size_t instructions = 0;
  for (const Function& function : program.functions) instructions += function.instructions.size();
  return instructions <= most_chosen;
}

Products products(const Inputs& inputs, const Limits& limits, Goal goal) {
  renew_time_limit(limits);
  PipelineOptions options;
  options.limits = limits;
  options.goals = {goal};
  return run_pipeline(inputs, options);
}

OperationsByName operations_of(const Program& program) {
  OperationsByName operations;
  for (const Function& function : program.functions) {
    operations.emplace(function.name, count_operations(function));
  }
  return operations;
}

}  // namespace

Version LoadedVersion::version() const {
  return {model,
          scene ? &*scene : nullptr,
          *products.checked,
          products.program ? *products.program : *products.lowered,
          products.diagnostics,
          operations.empty() ? nullptr : &operations};
}

std::string system_name(const Inputs& inputs, const Limits& limits) {
  const Products checked = products(inputs, limits, Goal::check);
  return checked.checked ? checked.checked->scene.base_name : std::string();
}

Diagnostics mistakes(const Inputs& inputs, const Limits& limits) {
  return products(inputs, limits, Goal::inspect).diagnostics;
}

Result<LoadedVersion> load_version(const Inputs& inputs, const Limits& limits) {
  LoadedVersion loaded{inputs};
  loaded.products = products(inputs, limits, Goal::lower);
  if (!loaded.products.lowered) return loaded.products.diagnostics;
  const bool is_emitted_otherwise = needs_forms(loaded.products.checked->scene);
  if (is_emitted_otherwise || is_small(*loaded.products.lowered)) {
    Products chosen = products(inputs, limits, Goal::choose);
    if (chosen.program) loaded.operations = operations_of(*chosen.program);
    if (is_emitted_otherwise) loaded.products = std::move(chosen);
  }
  Diagnostics found = loaded.products.diagnostics;
  if (!loaded.products.lowered && !loaded.products.program) return found;
  loaded.model = *parse_model(inputs.model, limits);
  if (inputs.scene != nullptr) loaded.scene = *parse_scene(inputs.scene, limits);
  return {std::move(loaded), std::move(found)};
}

}  // namespace elgen::cli
