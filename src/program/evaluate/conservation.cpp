// find_conservation: L = v.p - E, so L contains no t if E and p contain no t. A momentum p_i is
// constant if row i of dL/dq, of each force and of B is 0, and column i of A is 0.
#include "program/evaluate/conservation.hpp"

#include <algorithm>

#include "elgen/references.hpp"
#include "program/evaluate/subject.hpp"

namespace elgen {
namespace {

/// True if every entry with is_selected(row, column) is 0. With `needs_proof`, each 0 must be
/// proved and the function must exist. Without `needs_proof`, a zero found only by sampling is
/// accepted, and a missing function counts as 0.
template <class Stands>
bool are_entries_zero(const Program& program, OutputKind kind, bool needs_proof,
                      const Stands& is_selected) {
  const Function* const function = find_function(program, kind);
  if (function == nullptr) return !needs_proof;
  const Field& field = function->fields.front();
  for (std::uint32_t i = 0; i < field.entries.size(); ++i) {
    if (!is_selected(i / field.columns, i % field.columns)) continue;
    if (!loads_zero(program, function->instructions[field.entries[i]])) return false;
    if (needs_proof && std::ranges::count(function->sampled_zeros, i) > 0) return false;
  }
  return true;
}

}  // namespace

Conservation find_conservation(const Model& model, const Program& program, bool has_inputs,
                               bool needs_proof) {
  Conservation result;
  for (std::uint32_t i = 0; i < model.velocities.size(); ++i) {
    const auto has_row = [&](OutputKind kind) {
      return !are_entries_zero(program, kind, needs_proof,
                               [i](auto row, auto) { return row == i; });
    };
    const bool is_forced = (has_inputs && has_row(OutputKind::input_matrix)) ||
                           has_row(OutputKind::applied_force) || has_row(OutputKind::dissipation);
    const bool is_held = !model.constraints.empty() &&
                         !are_entries_zero(program, OutputKind::constraint_jacobian, needs_proof,
                                           [i](auto, auto column) { return column == i; });
    const bool is_constant = !is_forced && !is_held && !has_row(OutputKind::position_gradient);
    if (is_constant && !model.velocities[i].rotation) result.momenta.push_back(i);
    result.is_forced = result.is_forced || is_forced;
  }
  for (const OutputKind kind : {OutputKind::energy_function, OutputKind::momentum}) {
    const Function* const function = find_function(program, kind);
    result.has_time = result.has_time || (function != nullptr && contains_time(model, *function));
  }
  return result;
}

bool contains_time(const Model& model, const Function& function) {
  return std::ranges::any_of(function.instructions, [&model](const Instruction& instruction) {
    if (instruction.opcode != Opcode::open_value) return instruction.opcode == Opcode::time;
    const OpenFunction& open = model.functions[model.open_values[instruction.a].function];
    return std::ranges::any_of(open.arguments, [&model](ExpressionId argument) {
      return contains_leaf(model, argument, Opcode::time);
    });
  });
}

}  // namespace elgen
