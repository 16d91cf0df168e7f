// arguments: what a function takes is the output table's affair.
#include "elgen/arguments.hpp"

namespace elgen {

std::vector<Opcode> arguments_of(const Model& model, const Function& function) {
  LeafSet taken = Opcode::parameter | Opcode::coordinate | output_row(function.kind).takes;
  const bool mass_takes_velocity = function.kind == OutputKind::mass_matrix && !model.quadratic;
  if (mass_takes_velocity) taken |= Opcode::velocity;
  if (model.uses_time) taken |= Opcode::time;
  std::vector<Opcode> list;
  for (const LeafRow& leaf : leaf_table) {
    if (taken.has_any(leaf.id)) list.push_back(leaf.id);
  }
  return list;
}

}  // namespace elgen
