// lower: EquationsOfMotion -> Program, one output at a time: import, flatten, factor, eliminate
// common subexpressions, turn signs, linearise.
#include "elgen/lower.hpp"

#include <cln/exception.h>
#include <fmt/core.h>

#include <cassert>

#include "derive/lower/from_ginac.hpp"
#include "elgen/outputs.hpp"
#include "inspect/singular_mass.hpp"
#include "program/network/cheapest.hpp"
#include "program/network/linearise.hpp"

namespace elgen {
namespace {

/// Where the output divides by pivots of M, the message names the rate whose M_ii is 0.
Diagnostic zero_denominator(const Program& program, const OutputRequest& request) {
  if (!divides_by_mass(output_row(request.kind))) {
    return {Code::E312, request.span,
            fmt::format("a denominator of `{}` is 0, whatever the state is", request.name)};
  }
  if (request.kind == OutputKind::constrained_inverse_dynamics) return redundant_inputs(request);
  for (const Function& known : program.functions) {
    if (known.kind != OutputKind::mass_matrix) continue;
    const std::size_t n = known.fields[0].rows;
    for (std::size_t i = 0; i < n; ++i) {
      const std::uint32_t entry = known.fields[0].entries[i * n + i];
      if (loads_zero(program, known.instructions[entry])) {
        return no_kinetic_energy(request, program.leaves.v[i]);
      }
    }
  }
  return singular_mass_matrix(request);
}

Diagnostics lower_output(const EquationsOfMotion& equations, const OutputRequest& request,
                         const Limits& limits, Program& program) {
  Result<ImportedOutput> imported = from_ginac(equations, request, limits.derived_nodes);
  if (!imported) {
    const bool divides = imported.diagnostics.front().code == Code::E312;
    return divides ? Diagnostics{zero_denominator(program, request)} : imported.diagnostics;
  }
  Function function;
  function.kind = request.kind;
  function.user = request.user;
  function.name = request.name;
  function.fields = std::move(imported->fields);
  const Expressions expressions{std::move(imported->graph), std::move(imported->values)};
  try {
    linearise(cheapest_network(expressions, function), program, function);
  } catch (const cln::division_by_0_exception&) {
    // Only other rewritings show that a denominator is 0: sin(2*x) - 2*sin(x)*cos(x).
    return {zero_denominator(program, request)};
  }
  program.functions.push_back(std::move(function));
  return {};
}

}  // namespace

Result<Program> lower(const EquationsOfMotion& equations, const std::vector<OutputRequest>& outputs,
                      const Limits& limits) {
  Program program;
  program.leaves = leaf_names(equations);
  for (const OutputRequest& request : outputs) {
    if (output_row(request.kind).steps) continue;
    Diagnostics errors = lower_output(equations, request, limits, program);
    if (!errors.empty()) return errors;
  }
  assert(check_invariants(program).empty());
  return program;
}

}  // namespace elgen
