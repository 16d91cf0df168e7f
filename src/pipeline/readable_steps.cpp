// readable_steps: the functions of elgen/steps.hpp, and the names of the masses.
#include "pipeline/readable_steps.hpp"

#include "elgen/cancel.hpp"
#include "elgen/choose.hpp"
#include "elgen/lower.hpp"
#include "elgen/steps.hpp"

namespace elgen {
namespace {

std::string name_of(const Model& model, const Entity& origin) {
  if (origin.kind == EntityKind::point) return model.points[origin.index].name;
  if (origin.kind == EntityKind::body) return model.bodies[origin.index].name;
  return {};
}

}  // namespace

Result<ReadableSteps> readable_steps(const Lagrangian& lagrangian, const CheckedModel& checked,
                                     const Limits& limits) {
  const Result<Steps> derived = derive_steps(lagrangian);
  if (!derived) return derived.diagnostics;
  Result<Program> lowered = lower(derived->equations, derived->requests, limits);
  if (!lowered) return lowered.diagnostics;
  const Program recursive = cancel(std::move(*lowered));
  Result<Choice> choice = choose(recursive, present(recursive), {});
  if (!choice) return choice.diagnostics;
  ReadableSteps result{std::move(choice->program), {}};
  for (const Entity& mass : derived->masses) {
    result.masses.push_back(name_of(checked.model, mass));
  }
  return result;
}

}  // namespace elgen
