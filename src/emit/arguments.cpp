// arguments: what a function takes is the output table's affair; one switch for their names.
#include "arguments.hpp"

#include <fmt/format.h>

#include <string_view>
#include <unordered_map>

namespace elgen {
namespace {

std::string member_text(const Model& model, const Parameter& parameter) {
  const ParameterArray& array = model.parameter_arrays[parameter.array];
  return array.is_array ? fmt::format("{}[{}]", array.name, parameter.element) : array.name;
}

}  // namespace

std::vector<Argument> arguments_of(const Model& model, const Function& function) {
  const OutputRow& row = output_row(function.kind);
  const bool mass_takes_velocity = function.kind == OutputKind::mass_matrix && !model.quadratic;
  std::vector<Argument> list = {Argument::parameters, Argument::coordinates};
  const auto add = [&list](bool is_taken, Argument argument) {
    if (is_taken) list.push_back(argument);
  };
  add(row.takes_velocity || mass_takes_velocity, Argument::velocities);
  add(row.takes_acceleration, Argument::accelerations);
  add(row.takes_input, Argument::inputs);
  add(model.uses_time, Argument::time);
  return list;
}

std::size_t argument_size(const Model& model, Argument argument) {
  switch (argument) {
    case Argument::parameters:
      return model.parameters.size();
    case Argument::coordinates:
      return model.coordinates.size();
    case Argument::velocities:
    case Argument::accelerations:
      return model.velocities.size();
    case Argument::inputs:
      return model.inputs.size();
    case Argument::time:
      break;
  }
  return 1;
}

std::vector<std::string> parameter_members(const Model& model, const LeafNames& leaves) {
  std::unordered_map<std::string_view, const Parameter*> known;
  for (const Parameter& parameter : model.parameters) known.emplace(parameter.name, &parameter);
  std::vector<std::string> members;
  for (const std::string& leaf : leaves.parameters) {
    const auto found = known.find(leaf);
    members.push_back(found == known.end() ? leaf : member_text(model, *found->second));
  }
  return members;
}

std::optional<Argument> argument_of(Opcode opcode) {
  static_assert(static_cast<int>(Opcode::time) - static_cast<int>(Opcode::parameter) ==
                static_cast<int>(Argument::time));
  if (opcode < Opcode::parameter || opcode > Opcode::time) return std::nullopt;
  return static_cast<Argument>(static_cast<int>(opcode) - static_cast<int>(Opcode::parameter));
}

std::string variable_text(const Instruction& instruction) {
  const std::string_view name = argument_name(*argument_of(instruction.opcode));
  return instruction.opcode == Opcode::time ? std::string(name)
                                            : fmt::format("{}[{}]", name, instruction.a);
}

}  // namespace elgen
