// parts: picked where they are, derived where not.
#include "pipeline/parts.hpp"

#include "elgen/certificate.hpp"
#include "evaluate/subject.hpp"
#include "pipeline/recursive_program.hpp"

namespace elgen {
namespace {

/// The functions of `program` that are needed; none where one is missing.
std::optional<Program> selected(const Program& program, const std::vector<OutputRequest>& needed) {
  Program some{program.leaves, program.constants};
  for (const OutputRequest& request : needed) {
    const Function* known = find_function(program, request.kind);
    if (known == nullptr) return std::nullopt;
    some.functions.push_back(*known);
  }
  return some;
}

}  // namespace

std::optional<Program> known_parts(const CheckedModel& checked, const Program& recursive) {
  const std::vector<OutputRequest> needed = needed_parts(checked.model, checked.scene);
  return needed.empty() ? std::nullopt : selected(recursive, needed);
}

Result<SolutionParts> parts(const Lagrangian& lagrangian, const CheckedModel& checked,
                            const Program& recursive, const Limits& limits) {
  const std::vector<OutputRequest> needed = needed_parts(checked.model, checked.scene);
  if (needed.empty()) return SolutionParts{};
  std::optional<Program> known = selected(recursive, needed);
  if (known) return SolutionParts{std::move(known)};
  // Where a limit is in the way, solutions are judged by the code's own bound.
  return SolutionParts{recursive_program(lagrangian, needed, limits).value};
}

}  // namespace elgen
