// Instructions: appends to a Function with value numbering, so that nothing is computed twice.
#pragma once

#include <unordered_map>

#include "elgen/program.hpp"

namespace elgen {

class InstructionBuilder {
 public:
  explicit InstructionBuilder(Function& function) : function_(function) {
    for (std::uint32_t at = 0; at < function.instructions.size(); ++at) {
      known_.emplace(function.instructions[at], at);
    }
  }

  /// The index of the instruction, which is appended unless the function already contains an equal
  /// instruction.
  std::uint32_t add(const Instruction& instruction) {
    const auto next = static_cast<std::uint32_t>(function_.instructions.size());
    const auto [known, is_new] = known_.emplace(instruction, next);
    return is_new ? append(instruction) : known->second;
  }

  /// Appends the instruction even if the function already contains an equal instruction.
  std::uint32_t append(const Instruction& instruction) {
    function_.instructions.push_back(instruction);
    function_.names.emplace_back();
    return static_cast<std::uint32_t>(function_.instructions.size() - 1);
  }

  std::uint32_t add(Opcode opcode, std::uint32_t a, std::uint32_t b = 0) {
    return add(Instruction{.opcode = opcode, .a = a, .b = b});
  }

  /// Adds all instructions of `from` and returns the indices of their values. Instructions that
  /// have no name yet get the name in `from`.
  std::vector<std::uint32_t> add_all(const Function& from) {
    std::vector<std::uint32_t> places;
    for (std::size_t at = 0; at < from.instructions.size(); ++at) {
      places.push_back(add(renumber_operands(from.instructions[at], places)));
      merge_name(function_.names[places.back()], from.names[at]);
    }
    return places;
  }

 private:
  Function& function_;
  std::unordered_map<Instruction, std::uint32_t, InstructionHash> known_ = {};
};

}  // namespace elgen
