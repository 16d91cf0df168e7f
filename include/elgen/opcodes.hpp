// Opcodes: the operations of a Program, leaves among them, as opcodes.def and leaves.def list them.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

namespace elgen {

enum class Opcode : std::uint8_t {
#define ELGEN_OPCODE(name, operands, tag) name,
#include "elgen/opcodes.def"
#undef ELGEN_OPCODE
};

struct OpcodeRow {
  Opcode id;
  std::string_view name;
  std::size_t operands;
  int tag;
};

/// opcodes.def
inline constexpr std::array opcode_table{
#define ELGEN_OPCODE(name, operands, tag) OpcodeRow{Opcode::name, #name, operands, tag},
#include "elgen/opcodes.def"
#undef ELGEN_OPCODE
};

[[nodiscard]] constexpr const OpcodeRow& opcode_row(Opcode opcode) {
  return opcode_table[static_cast<std::size_t>(opcode)];
}

/// A kind of leaf.
struct LeafRow {
  Opcode id;
  std::string_view member;  ///< "parameters": of PerLeaf
  std::string_view symbol;  ///< "q"
  std::string_view type;    ///< "Coordinates<Scalar>"
  int rank;
};

/// leaves.def
inline constexpr std::array leaf_table{
#define ELGEN_LEAVES(kind, member, symbol, type, tag, rank) \
  LeafRow{Opcode::kind, #member, symbol, type, rank},
#include "elgen/leaves.def"
#undef ELGEN_LEAVES
};

[[nodiscard]] constexpr bool is_leaf(Opcode opcode) {
  return opcode >= leaf_table.front().id && opcode <= leaf_table.back().id;
}

/// Of a leaf.
[[nodiscard]] constexpr const LeafRow& leaf_row(Opcode leaf) {
  return leaf_table[static_cast<std::size_t>(leaf) -
                    static_cast<std::size_t>(leaf_table.front().id)];
}

}  // namespace elgen
