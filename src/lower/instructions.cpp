// Few are added, so that looking through all of them costs nothing.
#include "lower/instructions.hpp"

#include <algorithm>

namespace elgen {

std::uint32_t Instructions::add(const Instruction& instruction) {
  std::vector<Instruction>& all = function_.instructions;
  const auto known = std::find(all.begin(), all.end(), instruction);
  const auto at = static_cast<std::uint32_t>(known - all.begin());
  if (known == all.end()) {
    all.push_back(instruction);
    function_.names.emplace_back();
  }
  return at;
}

std::uint32_t Instructions::add(Opcode opcode, std::uint32_t a, std::uint32_t b) {
  return add(Instruction{.opcode = opcode, .a = a, .b = b});
}

}  // namespace elgen
