// Opcodes: the operations of a Program. The leaves of leaves.def are among them.
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

inline constexpr std::array opcode_table{
#define ELGEN_OPCODE(name, operands, tag) OpcodeRow{Opcode::name, #name, operands, tag},
#include "elgen/opcodes.def"
#undef ELGEN_OPCODE
};

[[nodiscard]] constexpr const OpcodeRow& opcode_row(Opcode opcode) {
  return opcode_table[static_cast<std::size_t>(opcode)];
}

/// The owner of the leaves of a kind: the system, or each entry of a list of a Model.
enum class LeafOwner : std::uint8_t {
  system,
  parameters,
  open_values,
  coordinates,
  velocities,
  constraints,
  inputs
};

/// The opcodes that are leaves, as a separate enum, so that a switch over them can be exhaustive.
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

/// The kind of a leaf. The opcode must be a leaf.
[[nodiscard]] constexpr LeafKind leaf_kind(Opcode opcode) {
  return static_cast<LeafKind>(static_cast<int>(opcode) - static_cast<int>(Opcode::constant) - 1);
}

/// True for a leaf. opcodes.def lists the leaves between `constant` and `negate`.
[[nodiscard]] constexpr bool is_leaf(Opcode opcode) {
  return opcode > Opcode::constant && opcode < Opcode::negate;
}

/// The condition under which the leaves of a kind are an argument of emitted functions.
enum class ArgumentRule : std::uint8_t {
  always,   ///< always, also if the list of leaves is empty
  if_any,   ///< if the system has leaves of the kind
  if_used,  ///< if a function of the program takes the kind; otherwise such leaves have no names
  never     ///< not in emitted functions: E occurs in `conserved`, multipliers in derivations
};

/// The unit of a leaf. [e] is the unit of the entry e of the model that owns the leaf.
enum class LeafUnit : std::uint8_t {
  second,
  joule,
  entry_unit,        ///< [e]
  entry_per_second,  ///< [e]/s
  joule_per_entry,   ///< J/[e]
  open_value_unit,   ///< of f, df/dx_i, d2f/dx_i dx_j: [f], [f]/[x_i], [f]/([x_i] [x_j])
  multiplier_unit,   ///< W/[r], r = df/dt or phi of the constraint
};

/// The groups of factors, in the order in which books write a product.
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

/// The notation of a kind of leaf.
struct LeafNotation {
  std::string_view symbol;      ///< "q"
  std::string_view type;        ///< type of the argument: "Coordinates<Scalar>"
  int rank;                     ///< position among the factors of a product; unique
  std::string_view text;        ///< in models: "dot({})"; {} is the name of the owning entry
  std::string_view identifier;  ///< in code and dumps: "{}_dot"
  std::string_view latex;       ///< "\\dot{s}"; s is the symbol of the owning entry
  std::string_view own_latex;   ///< as `latex`, if the velocity has its own symbol s (rotations)
};

/// The use of a kind of leaf in products, functions and states.
struct LeafUse {
  FactorGroup group;
  LeafUnit unit;
  ArgumentRule argument_rule;
  bool is_zero_at_rest;  ///< true for rates and causes of motion, which are 0 at rest
  bool is_settable;      ///< true: `--state` can set the leaf, but a start has no value for it
};

struct LeafRow : LeafNotation, LeafUse {
  Opcode id = {};
  std::string_view member = {};  ///< member of LeafMembers: "parameters"
  LeafOwner owner = {};
};

[[nodiscard]] std::span<const LeafRow> leaf_table();
[[nodiscard]] const LeafRow& leaf_row(Opcode leaf);

/// True if a system has exactly one leaf of the kind.
[[nodiscard]] inline bool is_single(Opcode leaf) {
  return leaf_row(leaf).owner == LeafOwner::system;
}

/// True if a state contains leaves of the kind `leaf`: functions may take such leaves, and the kind
/// is not `parameter`.
[[nodiscard]] inline bool is_in_state(Opcode leaf) {
  return leaf != Opcode::parameter && leaf_row(leaf).argument_rule != ArgumentRule::never;
}

/// A set of kinds of leaves: bit k stands for the opcode with number k.
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
