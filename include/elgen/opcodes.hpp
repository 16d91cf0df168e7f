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

inline constexpr std::array leaf_kinds{
#define ELGEN_LEAVES(kind, ...) LeafKind::kind,
#include "elgen/leaves.def"
#undef ELGEN_LEAVES
};
inline constexpr std::size_t leaf_kind_count = leaf_kinds.size();

/// None of the enumerators where the operation is no leaf.
[[nodiscard]] constexpr LeafKind leaf_kind(Opcode opcode) {
  return static_cast<LeafKind>(static_cast<int>(opcode) - static_cast<int>(Opcode::constant) - 1);
}

/// Leaves stand between these, see opcodes.def.
[[nodiscard]] constexpr bool is_leaf(Opcode opcode) {
  return opcode > Opcode::constant && opcode < Opcode::negate;
}

/// Whether emitted functions take a kind of leaf.
enum class Passed : std::uint8_t {
  always,    ///< even an empty list
  if_any,    ///< if the system has one
  if_taken,  ///< if an output of the program takes the kind: only then do its leaves have names
  never      ///< E occurs in `conserved`, multipliers in derivations
};

/// The unit of a leaf: fixed, by the declared unit of its entry of the model, or by expressions.
enum class LeafUnit : std::uint8_t {
  second,
  joule,
  of_entry,          ///< [q], [v], [u], a parameter's
  entry_per_second,  ///< [v]/s
  joule_per_entry,   ///< J/[v]
  of_open_value,     ///< [f]/([x_i] [x_j])
  of_multiplier,     ///< a multiplier times the rate of its equation is a power
};

/// The groups of factors in the order in which books write a product.
enum class FactorGroup : std::uint8_t {
  multiplier,
  parameter,
  sum,
  coordinate,
  rate,
  acceleration,
  input,
  function
};

/// How a kind of leaf is written.
struct LeafText {
  std::string_view symbol;      ///< "q"
  std::string_view type;        ///< "Coordinates<Scalar>"
  int rank;                     ///< of a factor, among those of a product
  std::string_view text;        ///< "dot({})", of the owner's name
  std::string_view identifier;  ///< "{}_dot"
  std::string_view latex;       ///< "\\dot{s}": s is the symbol of its entry
  std::string_view own_latex;   ///< of those of a velocity that has a symbol of its own
};

/// The use of a kind of leaf in functions, states and products.
struct LeafUse {
  FactorGroup group;
  LeafUnit unit;
  Passed passed;
  bool moves;      ///< a rate or a cause of motion: 0 in a system at rest
  bool is_stated;  ///< `--state` gives it, besides what a start has
};

/// A kind of leaf.
struct LeafRow : LeafText, LeafUse {
  Opcode id = {};
  std::string_view member = {};  ///< "parameters": of PerLeaf
  LeafOwner of = {};
};

[[nodiscard]] std::span<const LeafRow> leaf_table();
[[nodiscard]] const LeafRow& leaf_row(Opcode leaf);

/// Whether a system has one leaf of the kind, not a list of them.
[[nodiscard]] inline bool is_single(Opcode leaf) { return leaf_row(leaf).of == LeafOwner::system; }

/// Whether the states of a system differ in the kind: functions take it, and it is no parameter.
[[nodiscard]] inline bool is_of_state(Opcode leaf) {
  return leaf != Opcode::parameter && leaf_row(leaf).passed != Passed::never;
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
