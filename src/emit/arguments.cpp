// arguments: what a function takes is the output table's affair; one switch for their names.
#include "arguments.hpp"

#include <fmt/format.h>

#include <array>
#include <cctype>
#include <string_view>
#include <unordered_map>

namespace elgen {
namespace {

std::string member_text(const Model& model, const Parameter& parameter) {
  const ParameterArray& array = model.parameter_arrays[parameter.array];
  return array.is_array ? fmt::format("{}[{}]", array.name, parameter.element) : array.name;
}

bool is_word(char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_'; }

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

std::string_view argument_name(Argument argument) {
  constexpr std::array<std::string_view, 6> names{"p", "q", "v", "a", "u", "t"};
  return names[static_cast<std::size_t>(argument)];
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

std::string variable_text(const Instruction& instruction) {
  switch (instruction.opcode) {
    case Opcode::coordinate:
      return fmt::format("q[{}]", instruction.a);
    case Opcode::velocity:
      return fmt::format("v[{}]", instruction.a);
    case Opcode::acceleration:
      return fmt::format("a[{}]", instruction.a);
    case Opcode::input:
      return fmt::format("u[{}]", instruction.a);
    default:
      return "t";
  }
}

bool mentions(std::string_view text, std::string_view word) {
  for (std::size_t at = text.find(word); at != std::string_view::npos;
       at = text.find(word, at + 1)) {
    const std::size_t end = at + word.size();
    const std::string_view before = text.substr(0, at);
    const bool is_member = before.ends_with(".") || before.ends_with("->");
    const bool begins = at == 0 || (!is_word(text[at - 1]) && !is_member);
    const bool ends = end == text.size() || !is_word(text[end]);
    if (begins && ends) return true;
  }
  return false;
}

}  // namespace elgen
