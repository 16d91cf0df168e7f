// arguments: what a function takes is the output table's affair.
#include "elgen/arguments.hpp"

namespace elgen {

std::vector<Opcode> arguments_of(const Model& model, const Function& function) {
  const OutputRow& row = output_row(function.kind);
  const bool mass_takes_velocity = function.kind == OutputKind::mass_matrix && !model.quadratic;
  std::vector<Opcode> list{Opcode::parameter, Opcode::coordinate};
  if (row.takes_velocity || mass_takes_velocity) list.push_back(Opcode::velocity);
  if (row.takes_acceleration) list.push_back(Opcode::acceleration);
  if (row.takes_input) list.push_back(Opcode::input);
  if (model.uses_time) list.push_back(Opcode::time);
  return list;
}

std::size_t argument_size(const Model& model, Opcode argument) {
  const std::size_t velocities = model.velocities.size();
  const PerLeaf<std::size_t, std::size_t> sizes{model.parameters.size(),
                                                model.coordinates.size(),
                                                velocities,
                                                velocities,
                                                model.inputs.size(),
                                                1};
  const std::size_t* const size = list_of(sizes, argument);
  return size != nullptr ? *size : sizes.t;
}

}  // namespace elgen
