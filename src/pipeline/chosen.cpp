// chosen: choose, then what the scene's methods make of its choice.
#include "pipeline/chosen.hpp"

#include "elgen/integrate.hpp"
#include "pipeline/recursive_program.hpp"

namespace elgen {
namespace {

/// What the step calls, in the forms that the scene would choose.
Result<Program> calls_of(const Lagrangian& lagrangian, const CheckedModel& checked,
                         const OutputRequest& step, const Limits& limits) {
  Scene scene = checked.scene;
  scene.outputs = needed_for_step(checked.model, step);
  const Result<Program> recursive = recursive_program(lagrangian, scene.outputs, limits);
  if (!recursive) return recursive.diagnostics;
  Result<Choice> choice = choose(*recursive, present(*recursive), scene);
  if (!choice) return choice.diagnostics;
  return std::move(choice->program);
}

/// Its costs are those of its only form.
void add_costs(Choice& choice) {
  const Function& step = choice.program.functions.back();
  choice.program.readable.emplace_back();
  choice.costs.push_back({step.name, count_operations(step)});
}

}  // namespace

Result<Choice> chosen(const Lagrangian& lagrangian, const Program& recursive,
                      const ClosedForms& forms, const CheckedModel& checked, const Limits& limits) {
  Result<Choice> choice = choose(recursive, forms, checked.scene);
  if (!choice) return choice;
  for (const OutputRequest& output : checked.scene.outputs) {
    if (!output_row(output.kind).steps) continue;
    const Result<Program> calls = calls_of(lagrangian, checked, output, limits);
    if (!calls) return calls.diagnostics;
    Diagnostics errors = add_step(checked, output, *calls, choice->program);
    if (!errors.empty()) return errors;
    add_costs(*choice);
  }
  return choice;
}

}  // namespace elgen
