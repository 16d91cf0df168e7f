// lower: EquationsOfMotion -> Program, one output at a time: import, flatten, factor, eliminate
// common subexpressions, normalise signs, linearise.
#include "elgen/lower.hpp"

#include <cln/exception.h>
#include <fmt/core.h>

#include <algorithm>
#include <optional>
#include <utility>
#include <vector>

#include "derive/lower/from_ginac.hpp"
#include "elgen/outputs.hpp"
#include "inspect/singular_mass.hpp"
#include "program/network/cheapest.hpp"
#include "program/network/linearise.hpp"
#include "program/network/named_intermediates.hpp"

namespace elgen {
namespace {

/// The error for a denominator that is 0. If the output divides by pivots of M, the message names
/// the velocity whose M_ii is 0.
Diagnostic zero_denominator_error(const Program& program, const OutputRequest& request) {
  if (!divides_by_mass(output_row(request.kind))) {
    return {Code::E312, request.span,
            fmt::format("a denominator of `{}` is 0, whatever the state is", request.name)};
  }
  if (const auto fault = singular_system_error(request, {}, program.leaves)) return *fault;
  const auto mass = std::ranges::find(program.functions, OutputKind::mass_matrix, &Function::kind);
  const std::size_t n = mass == program.functions.end() ? 0 : mass->fields[0].rows;
  for (std::size_t i = 0; i < n; ++i) {
    const std::uint32_t entry = mass->fields[0].entries[i * n + i];
    if (loads_zero(program, mass->instructions[entry])) {
      return no_kinetic_energy_error(request, program.leaves.v[i]);
    }
  }
  return singular_mass_matrix_error(request);
}

/// A function before linearisation: a network instead of instructions.
struct FunctionNetwork {
  Function function = {};
  CostedNetwork network = {};
  NamedIntermediates value_names = {};
};

Result<FunctionNetwork> lower_by_route(const EquationsOfMotion& equations,
                                       const OutputRequest& request, const Limits& limits,
                                       const LeafNames& leaves) {
  Result<ImportedOutput> imported = from_ginac(equations, request, limits.derived_nodes);
  if (!imported) return imported.diagnostics;
  FunctionNetwork result;
  result.function.kind = request.kind;
  result.function.user = request.user;
  result.function.independent = request.independent;
  result.function.name = request.name;
  result.function.fields = std::move(imported->fields);
  result.function.elimination_order = std::move(imported->elimination);
  const Expressions expressions{std::move(imported->graph), std::move(imported->values)};
  result.value_names = named_intermediates(
      {expressions.graph, std::move(imported->intermediate_values)}, imported->value_names, leaves);
  result.network = std::move(networks_by_cost(expressions, result.function).front());
  return result;
}

/// Lowers an output by its cheapest route; of several equally cheap routes, by the first. Returns
/// zero_denominator_error() if a route has a denominator 0; otherwise, if every route fails, the
/// errors of the last route.
Diagnostics lower_output(const EquationsOfMotion& equations, const OutputRequest& request,
                         const Limits& limits, Program& program) {
  std::optional<FunctionNetwork> cheapest;
  Diagnostics errors;
  try {
    for (const EquationsOfMotion* const route : find_routes(equations, request)) {
      Result<FunctionNetwork> found = lower_by_route(*route, request, limits, program.leaves);
      if (!found) {
        errors = std::move(found.diagnostics);
        if (errors.front().code == Code::E312) return {zero_denominator_error(program, request)};
      } else if (!cheapest || found->network.cost < cheapest->network.cost) {
        cheapest = std::move(*found);
      }
    }
    if (!cheapest) return errors;
    linearise(cheapest->network.network, program, cheapest->function);
    name_intermediates(cheapest->value_names, program, cheapest->function);
  } catch (const cln::division_by_0_exception&) {
    // Some denominators become 0 only when they are rewritten, e.g. sin(2*x) - 2*sin(x)*cos(x).
    return {zero_denominator_error(program, request)};
  }
  program.functions.push_back(std::move(cheapest->function));
  return {};
}

}  // namespace

Result<Program> lower(const EquationsOfMotion& equations, const std::vector<OutputRequest>& outputs,
                      const Limits& limits) {
  Program program;
  program.leaves = leaf_names(equations);
  for (const OutputRequest& request : outputs) {
    if (output_row(request.kind).is_step) continue;
    Diagnostics errors = lower_output(equations, request, limits, program);
    if (!errors.empty()) return errors;
  }
  require_invariants(program);
  return program;
}

}  // namespace elgen
