// Instructions: adds to a Function, nothing twice.
#pragma once

#include <unordered_map>

#include "elgen/program.hpp"

namespace elgen {

class Instructions {
 public:
  explicit Instructions(Function& function);

  /// Where its value is, which may have been there before.
  std::uint32_t add(const Instruction& instruction);
  std::uint32_t add(Opcode opcode, std::uint32_t a, std::uint32_t b = 0);

 private:
  Function& function_;
  std::unordered_map<Instruction, std::uint32_t, InstructionHash> known_ = {};
};

}  // namespace elgen
