// Opcodes: the operations of a Program, leaves among them, as opcodes.def and leaves.def list them.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
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

/// The owner of one leaf of a kind: the whole system, or each entry of a list of a Model.
enum class LeafOwner : std::uint8_t {
  system,
  parameters,
  open_values,
  coordinates,
  velocities,
  constraints,
  inputs
};

/// The leaves alone, for switches over them.
enum class LeafKind : std::uint8_t {
#define ELGEN_LEAVES(kind, ...) kind,
#include "elgen/leaves.def"
#undef ELGEN_LEAVES
};

/// None of the enumerators where the operation is no leaf.
[[nodiscard]] constexpr LeafKind leaf_kind(Opcode opcode) {
  return static_cast<LeafKind>(static_cast<int>(opcode) - static_cast<int>(Opcode::constant) - 1);
}

/// Leaves stand between these, see opcodes.def.
[[nodiscard]] constexpr bool is_leaf(Opcode opcode) {
  return opcode > Opcode::constant && opcode < Opcode::negate;
}

/// A kind of leaf.
struct LeafRow {
  std::string_view symbol;      ///< "q"
  std::string_view type;        ///< "Coordinates<Scalar>"
  int rank;                     ///< of a factor, among those of a product
  std::string_view text;        ///< "dot({})", of the owner's name
  std::string_view identifier;  ///< "{}_dot"
  std::string_view latex;       ///< "\\dot{s}": s is the symbol of its entry
  std::string_view own_latex;   ///< of those of a velocity that has a symbol of its own
  Opcode id = {};
  std::string_view member = {};  ///< "parameters": of PerLeaf
  LeafOwner of = {};
};

[[nodiscard]] std::span<const LeafRow> leaf_table();
[[nodiscard]] const LeafRow& leaf_row(Opcode leaf);

/// Whether a system has one leaf of the kind, not a list of them.
[[nodiscard]] inline bool is_single(Opcode leaf) { return leaf_row(leaf).of == LeafOwner::system; }

/// Whether they exist for emitted functions only where a system has some, or where a function takes
/// them: the other lists are passed though they are empty.
[[nodiscard]] inline bool is_optional(Opcode leaf) {
  return leaf_row(leaf).of == LeafOwner::open_values || leaf == Opcode::momentum ||
         leaf == Opcode::reference;
}

/// A set of kinds of leaves.
class LeafSet {
 public:
  constexpr LeafSet() = default;
  constexpr LeafSet(Opcode leaf) : bits_(1U << static_cast<unsigned>(leaf)) {}

  [[nodiscard]] constexpr bool has_any(LeafSet other) const { return (bits_ & other.bits_) != 0; }

  constexpr LeafSet& operator|=(LeafSet other) {
    bits_ |= other.bits_;
    return *this;
  }
  friend constexpr LeafSet operator|(LeafSet left, LeafSet right) { return left |= right; }
  friend constexpr bool operator==(LeafSet, LeafSet) = default;

 private:
  std::uint32_t bits_ = 0;
};

constexpr LeafSet operator|(Opcode left, Opcode right) { return LeafSet(left) | right; }

}  // namespace elgen
