// parts: picked where they are, derived where not.
#include "pipeline/parts.hpp"

#include "elgen/certificate.hpp"
#include "evaluate/subject.hpp"
#include "pipeline/recursive_program.hpp"

namespace elgen {

Program known_parts(const CheckedModel& checked, const Program& recursive) {
  Program some{recursive.leaves, recursive.constants};
  for (const OutputRequest& request : needed_parts(checked.model, checked.scene)) {
    const Function* known = find_function(recursive, request.kind);
    if (known == nullptr) return {};
    some.functions.push_back(*known);
  }
  return some;
}

Result<Program> parts(const Lagrangian& lagrangian, const CheckedModel& checked,
                      const Program& recursive, const Limits& limits) {
  const std::vector<OutputRequest> needed = needed_parts(checked.model, checked.scene);
  if (needed.empty()) return Program{};
  Program known = known_parts(checked, recursive);
  if (!known.functions.empty()) return known;
  // Where a limit is in the way, solutions are judged by the code's own bound.
  return recursive_program(lagrangian, needed, limits).value.value_or(Program{});
}

}  // namespace elgen
