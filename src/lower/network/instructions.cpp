// Instructions: value numbers, by what is computed.
#include "lower/network/instructions.hpp"

namespace elgen {

Instructions::Instructions(Function& function) : function_(function) {
  for (std::uint32_t at = 0; at < function.instructions.size(); ++at) {
    known_.emplace(function.instructions[at], at);
  }
}

std::uint32_t Instructions::add(const Instruction& instruction) {
  const auto next = static_cast<std::uint32_t>(function_.instructions.size());
  const auto [known, is_new] = known_.emplace(instruction, next);
  if (is_new) {
    function_.instructions.push_back(instruction);
    function_.names.emplace_back();
  }
  return known->second;
}

std::uint32_t Instructions::add(Opcode opcode, std::uint32_t a, std::uint32_t b) {
  return add(Instruction{.opcode = opcode, .a = a, .b = b});
}

Function without_repeats(const Function& function) {
  Function result = function;
  result.instructions.clear();
  result.names.clear();
  Instructions instructions(result);
  std::vector<std::uint32_t> places;
  for (Instruction i : function.instructions) {
    if (operand_count(i) > 0) i.a = places[i.a];
    if (operand_count(i) > 1) i.b = places[i.b];
    places.push_back(instructions.add(i));
  }
  for (Field& field : result.fields) {
    for (std::uint32_t& entry : field.entries) entry = places[entry];
  }
  return result;
}

}  // namespace elgen
