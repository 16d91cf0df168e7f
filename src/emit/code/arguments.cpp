// arguments: elements of arrays by their declaration, everything else by its number.
#include "emit/code/arguments.hpp"

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

std::string variable_text(const Instruction& instruction) {
  const std::string_view name = leaf_row(instruction.opcode).symbol;
  return instruction.opcode == Opcode::time ? std::string(name)
                                            : fmt::format("{}[{}]", name, instruction.a);
}

}  // namespace elgen
