// presented: what is dropped from the parts of the equations is lost by all that is made of them.
#include "pipeline/presented.hpp"

#include <algorithm>

#include "elgen/certificate.hpp"
#include "pipeline/recursive_program.hpp"

namespace elgen {
namespace {

/// The outputs, and the parts of those that are reduced, each once.
std::vector<OutputRequest> with_parts(const Scene& scene) {
  std::vector<OutputRequest> all;
  for (const OutputRequest& output : scene.outputs) {
    if (!output_row(output.kind).repeats) all.push_back(output);
  }
  for (const OutputRequest& part : scene.dropping->parts) {
    const bool is_known = std::any_of(all.begin(), all.end(), [&](const OutputRequest& output) {
      return output.kind == part.kind;
    });
    if (!is_known) all.push_back(part);
  }
  return all;
}

/// The forms of `program`'s functions out of those of a program that has more.
std::vector<ClosedFunction> selected(const Program& program, const Program& whole,
                                     const ClosedForms& forms) {
  std::vector<ClosedFunction> result;
  for (const Function& function : program.functions) {
    ClosedFunction& closed = result.emplace_back();
    for (std::size_t i = 0; i < whole.functions.size(); ++i) {
      const Function& known = whole.functions[i];
      if (known.kind == function.kind && known.user == function.user) closed = forms.functions[i];
    }
  }
  return result;
}

/// The closed forms of `recursive` without their small terms. The parts are derived with them, so
/// that all are sums over one algebra.
Result<ReducedForms> reduced(const Lagrangian& lagrangian, const CheckedModel& checked,
                             const Program& recursive, const Limits& limits) {
  const auto& [model, scene] = checked;
  const std::vector<OutputRequest> wanted = with_parts(scene);
  const Result<Program> program = recursive_program(lagrangian, wanted, limits);
  if (!program) return program.diagnostics;
  Result<ReducedForms> reduced = drop_terms(*program, present(*program), model, *scene.dropping);
  if (!reduced) return reduced.diagnostics;
  Diagnostics refused = check_definiteness(model, scene, reduced->reduction);
  if (!refused.empty()) return refused;
  reduced->forms.functions = selected(recursive, *program, reduced->forms);
  return reduced;
}

}  // namespace

Result<Presented> presented(const Lagrangian& lagrangian, const CheckedModel& checked,
                            const Program& recursive, const Limits& limits) {
  Presented result{present(recursive), {}};
  if (checked.scene.dropping) {
    Result<ReducedForms> without = reduced(lagrangian, checked, recursive, limits);
    if (!without) return without.diagnostics;
    result.reduced = std::move(*without);
  }
  return result;
}

}  // namespace elgen
