// lower: EquationsOfMotion -> Program, one output at a time: import, flatten, factor, share, turn
// signs, linearise.
#include "elgen/lower.hpp"

#include <fmt/core.h>

#include <cassert>

#include "cheapest.hpp"
#include "from_ginac.hpp"
#include "linearise.hpp"

namespace elgen {
namespace {

Diagnostics lower_output(const EquationsOfMotion& equations, const OutputRequest& request,
                         const Limits& limits, Program& program) {
  Result<ImportedOutput> imported = from_ginac(equations, request, limits.derived_nodes);
  if (!imported) return imported.diagnostics;
  Function function;
  function.kind = request.kind;
  function.user = request.user;
  function.name = request.name;
  function.fields = std::move(imported->fields);
  const Expressions expressions{std::move(imported->graph), std::move(imported->values)};
  linearise(cheapest_network(expressions, function), program, function);
  program.functions.push_back(std::move(function));
  return {};
}

}  // namespace

Result<Program> lower(const EquationsOfMotion& equations, const std::vector<OutputRequest>& outputs,
                      const Limits& limits) {
  Program program;
  program.leaves = leaves_of(equations);
  for (const OutputRequest& request : outputs) {
    Diagnostics errors = lower_output(equations, request, limits, program);
    if (!errors.empty()) return errors;
  }
  assert(check_invariants(program).empty());
  return program;
}

}  // namespace elgen
