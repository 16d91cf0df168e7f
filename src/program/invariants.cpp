// find_invariant_violation: properties of every Program after every pass.
//
// Operands precede their users. Leaves and constants exist. Nothing is computed twice, except in
// repetitions, which execute the same operations in the same order. No instruction is dead. Every
// field has rows * columns entries. Unused operand slots are 0, so that equal instructions have
// equal bytes.
#include <fmt/core.h>

#include <stdexcept>
#include <unordered_set>

#include "elgen/program.hpp"

namespace elgen {
namespace {

std::size_t leaf_count(const Program& program, Opcode opcode) {
  if (opcode == Opcode::constant) return program.constants.size();
  if (opcode == Opcode::time) return program.leaves.uses_time ? 1 : 0;
  if (opcode == Opcode::step) return program.leaves.h.empty() ? 0 : 1;
  if (opcode == Opcode::energy) return 0;
  return is_leaf(opcode) ? elgen::leaf_count(program.leaves, opcode) : 1;
}

std::string instruction_error(const Program& program, const Function& function, std::size_t at) {
  const Instruction& instruction = function.instructions[at];
  const std::size_t operands = operand_count(instruction);
  if (operands == 0 && instruction.a >= leaf_count(program, instruction.opcode)) {
    return fmt::format("there is no leaf {}", instruction.a);
  }
  if (operands > 0 && instruction.a >= at) {
    return fmt::format("operand {} is not computed before", instruction.a);
  }
  if (operands > 1 && instruction.b >= at) {
    return fmt::format("operand {} is not computed before", instruction.b);
  }
  if (operands < 2 && instruction.b != 0) return "the unused operand is not 0";
  if (instruction.opcode != Opcode::call && instruction.function != FunctionId::sin) {
    return "only a call names a function";
  }
  return "";
}

/// Finds the instructions that pruning keeps, independently of the pruning code.
std::vector<bool> used_instructions(const Function& function) {
  std::vector<bool> used(function.instructions.size(), false);
  for (const std::uint32_t entry : entries_of(function)) used[entry] = true;
  for (const Instruction& instruction : function.instructions) {
    if (operand_count(instruction) > 0) used[instruction.a] = true;
    if (operand_count(instruction) > 1) used[instruction.b] = true;
  }
  return used;
}

std::string field_error(const Function& function) {
  for (const Field& field : function.fields) {
    if (field.entries.size() != std::size_t{field.rows} * field.columns) {
      return fmt::format("field `{}` has {} entries, not {} x {}", field.name, field.entries.size(),
                         field.rows, field.columns);
    }
    for (const std::uint32_t entry : field.entries) {
      if (entry >= function.instructions.size()) {
        return fmt::format("field `{}` refers to instruction {}", field.name, entry);
      }
    }
  }
  return "";
}

/// True if now = before + length, with `before` the same operand in the previous repetition. If
/// before < first (before the repetitions), true if now < first.
bool is_shifted(std::uint32_t before, std::uint32_t now, std::size_t first, std::uint32_t length) {
  return before < first ? now < first : now == before + length;
}

/// True for operations that the compiler's vector types support.
bool is_arithmetic(const Instruction& instruction) {
  return instruction.opcode != Opcode::call && instruction.opcode != Opcode::square_root;
}

/// The first fault of the repetitions; "" if there is none. Operands precede their users, so
/// operands of the first repetition lie in it or before it.
std::string repetition_error(const Function& function) {
  const auto& [length, count] = function.repeated;
  const std::size_t size = std::size_t{length} * count;
  if ((size == 0) != (length + count == 0) || size > function.instructions.size()) {
    return fmt::format("{} times {} of {} instructions are repeated", count, length,
                       function.instructions.size());
  }
  const std::size_t first = first_repeated_instruction(function);
  for (std::size_t at = first + length; at < function.instructions.size(); ++at) {
    const Instruction& before = function.instructions[at - length];
    Instruction now = function.instructions[at];
    const std::size_t operands = operand_count(now);
    bool is_alike =
        operands > 0 && is_arithmetic(now) && is_shifted(before.a, now.a, first, length);
    if (operands > 1) is_alike = is_alike && is_shifted(before.b, now.b, first, length);
    now.a = before.a;
    now.b = before.b;
    if (!is_alike || !(now == before)) {
      return fmt::format("instruction {}: does not repeat {}", at, at - length);
    }
  }
  return "";
}

std::string function_error(const Program& program, const Function& function) {
  if (function.names.size() != function.instructions.size()) {
    return fmt::format("{} names for {} instructions", function.names.size(),
                       function.instructions.size());
  }
  const std::string repetition = repetition_error(function);
  if (!repetition.empty()) return repetition;
  std::unordered_set<Instruction, InstructionHash> seen;
  for (std::size_t at = 0; at < function.instructions.size(); ++at) {
    const std::string broken = instruction_error(program, function, at);
    if (!broken.empty()) return fmt::format("instruction {}: {}", at, broken);
    if (at >= first_repeated_instruction(function)) continue;
    if (!seen.insert(function.instructions[at]).second) {
      return fmt::format("instruction {}: computed before", at);
    }
  }
  const std::string field = field_error(function);
  if (!field.empty()) return field;
  const std::vector<bool> used = used_instructions(function);
  for (std::size_t at = 0; at < used.size(); ++at) {
    if (!used[at]) return fmt::format("instruction {}: dead", at);
  }
  return "";
}

}  // namespace

std::string find_invariant_violation(const Program& program) {
  for (const Function& function : program.functions) {
    const std::string broken = function_error(program, function);
    if (!broken.empty()) return fmt::format("function `{}`: {}", function.name, broken);
  }
  return "";
}

void require_invariants(const Program& program) {
  const std::string broken = find_invariant_violation(program);
  if (!broken.empty()) throw std::logic_error(broken);
}

}  // namespace elgen
