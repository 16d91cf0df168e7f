// lower: EquationsOfMotion -> Program, one output at a time: import, flatten, factor, share, turn
// signs, linearise.
//
// Each function is lowered with common factors pulled out of its sums and without; the cheaper is
// kept (with, on a tie), since pulling out can undo what two sums would share.
#include "elgen/lower.hpp"

#include <fmt/core.h>

#include <cassert>

#include "factor.hpp"
#include "flatten.hpp"
#include "from_ginac.hpp"
#include "linearise.hpp"
#include "share.hpp"
#include "turn_signs.hpp"

namespace elgen {
namespace {

/// `dynamics` holds what depends on q, v and t alone.
bool belongs_to_dynamics(const OutputEquations& output) {
  const OutputRow& row = output_row(output.request.kind);
  return !row.takes_acceleration && !row.takes_input;
}

/// The equations a request stands for: its own, or for `dynamics` all that belong to it.
std::vector<const OutputEquations*> equations_for(const EquationsOfMotion& equations,
                                                  const OutputRequest& request) {
  std::vector<const OutputEquations*> wanted;
  for (const OutputEquations& output : equations.outputs) {
    const bool is_wanted =
        request.kind == OutputKind::dynamics
            ? belongs_to_dynamics(output)
            : output.request.kind == request.kind && output.request.user == request.user;
    if (is_wanted) wanted.push_back(&output);
  }
  return wanted;
}

std::vector<Field> fields_of(const OutputRequest& request, const ImportedOutputs& imported,
                             const std::vector<const OutputEquations*>& outputs) {
  if (request.kind != OutputKind::dynamics) return imported.fields.at(0);
  std::vector<Field> fields;
  for (std::size_t i = 0; i < outputs.size(); ++i) {
    for (Field field : imported.fields[i]) {
      field.name = outputs[i]->request.name;
      fields.push_back(std::move(field));
    }
  }
  return fields;
}

std::size_t cost_of(const Network& network, const Function& unfilled) {
  Program scratch;
  Function function = unfilled;
  linearise(network, scratch, function);
  return cost(count_operations(function));
}

Network shared_network(const Expressions& expressions) {
  Network network = make_network(expressions);
  share(network);
  turn_signs(network);
  return network;
}

Network cheapest_network(const Expressions& expressions, const Function& unfilled) {
  const Expressions flat = flatten(expressions);
  Network as_imported = shared_network(flat);
  Network factored = shared_network(factor(flat));
  const bool is_factored = cost_of(factored, unfilled) <= cost_of(as_imported, unfilled);
  return is_factored ? std::move(factored) : std::move(as_imported);
}

Diagnostics lower_output(const EquationsOfMotion& equations, const OutputRequest& request,
                         const Limits& limits, Program& program) {
  const std::vector<const OutputEquations*> outputs = equations_for(equations, request);
  if (outputs.empty()) {
    return {{Code::E912, request.span, fmt::format("`{}` was not derived", request.name)}};
  }
  Result<ImportedOutputs> imported = from_ginac(equations, outputs, limits.derived_nodes);
  if (!imported) return imported.diagnostics;
  Function function;
  function.kind = request.kind;
  function.user = request.user;
  function.name = request.name;
  function.fields = fields_of(request, *imported, outputs);
  const Expressions expressions{std::move(imported->graph), std::move(imported->values)};
  linearise(cheapest_network(expressions, function), program, function);
  program.functions.push_back(std::move(function));
  return {};
}

}  // namespace

Result<Program> lower(const EquationsOfMotion& equations, const std::vector<OutputRequest>& outputs,
                      const Limits& limits) {
  Program program;
  program.leaves = equations.leaves;
  for (const OutputRequest& request : outputs) {
    Diagnostics errors = lower_output(equations, request, limits, program);
    if (!errors.empty()) return errors;
  }
  assert(check_invariants(program).empty());
  return program;
}

}  // namespace elgen
