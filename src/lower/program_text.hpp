// What the printer and the reader of the text form of a Program share: the words.
#pragma once

#include <array>
#include <string_view>

#include "elgen/program.hpp"

namespace elgen {

struct OpcodeName {
  Opcode opcode;
  std::string_view name;
};

/// Every opcode but `call`, which is written as the function's own name.
inline constexpr std::array opcode_names{
    OpcodeName{Opcode::constant, "constant"},
    OpcodeName{Opcode::parameter, "parameter"},
    OpcodeName{Opcode::coordinate, "coordinate"},
    OpcodeName{Opcode::velocity, "velocity"},
    OpcodeName{Opcode::acceleration, "acceleration"},
    OpcodeName{Opcode::input, "input"},
    OpcodeName{Opcode::time, "time"},
    OpcodeName{Opcode::negate, "negate"},
    OpcodeName{Opcode::add, "add"},
    OpcodeName{Opcode::subtract, "subtract"},
    OpcodeName{Opcode::multiply, "multiply"},
    OpcodeName{Opcode::divide, "divide"},
    OpcodeName{Opcode::square_root, "square_root"},
};

/// How a function's heading names its output: as the table of outputs does, users' ones by their
/// kind.
[[nodiscard]] inline std::string_view kind_name(OutputKind kind) {
  switch (kind) {
    case OutputKind::user_value:
      return "user_value";
    case OutputKind::user_jacobian:
      return "user_jacobian";
    case OutputKind::user_bias:
      return "user_bias";
    default:
      return output_row(kind).name;
  }
}

/// The names a leaf opcode's operand is written by; null for other opcodes, constants and time.
[[nodiscard]] inline const std::vector<std::string>* leaf_spellings(const LeafNames& leaves,
                                                                    Opcode opcode) {
  switch (opcode) {
    case Opcode::parameter:
      return &leaves.parameters;
    case Opcode::coordinate:
      return &leaves.coordinates;
    case Opcode::velocity:
    case Opcode::acceleration:
      return &leaves.velocities;
    case Opcode::input:
      return &leaves.inputs;
    default:
      return nullptr;
  }
}

}  // namespace elgen
