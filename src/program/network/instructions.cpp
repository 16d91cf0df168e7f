// Instructions: value numbers, by what is computed.
#include "program/network/instructions.hpp"

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

}  // namespace elgen
