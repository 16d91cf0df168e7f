// The leaves of a Model: their names, numbers, units and declared ranges.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "elgen/leaves.hpp"
#include "elgen/model.hpp"

namespace elgen {

/// For each leaf the result of f(kind, entry), with the entry of `model` that owns the leaf; for t,
/// h and E, which no entry owns, the result of single(kind).
template <class T, class F, class Single>
[[nodiscard]] LeafValues<T> make_leaf_values(const Model& model, const F& f, const Single& single) {
  LeafValues<T> leaves;
#define ELGEN_LEAVES(kind, member, of, ...) \
  for (const auto& entry : model.of) leaves.member.push_back(f(Opcode::kind, entry));
#define ELGEN_LEAF(kind, member, ...) leaves.member = single(Opcode::kind);
#include "elgen/leaves.def"
#undef ELGEN_LEAVES
#undef ELGEN_LEAF
  return leaves;
}

/// The names of leaves: "m", "l[2]", "theta", "q[1]". The name of a velocity or an acceleration is
/// the text that leaf_text() prints inside dot(); a momentum has the name of its velocity. Momenta,
/// reference velocities and h have names only in programs with functions that take them; E has no
/// name.
struct LeafNames : LeafValues<std::string> {
  bool uses_time = false;
  std::vector<Assumption> assumptions = {};  ///< one for each parameter; empty: no assumptions
};

[[nodiscard]] Assumption assumption_of(const LeafNames& leaves, std::uint32_t parameter);

[[nodiscard]] LeafNames leaf_names(const Model& model);

/// Names the leaves of each kind in `takes`, if the kind has ArgumentRule::if_used. A list of
/// leaves gets the names of the velocities; a single leaf gets its symbol.
void name_optional_leaves(LeafSet takes, LeafNames& leaves);

/// True if a coordinate, parameter, input, function, prescribed motion or definition has the name.
[[nodiscard]] bool has_value_named(const Model& model, std::string_view name);

/// The name of the leaf E in `conserved`: "E", or `energy_function` if E names another value of the
/// model.
[[nodiscard]] std::string energy_name(const Model& model);

/// The leaf as text of the model language: "m", "dot(x)", "t".
[[nodiscard]] std::string leaf_text(const LeafNames& leaves, Opcode kind, std::uint32_t number);
[[nodiscard]] std::string leaf_text(const Model& model, Opcode kind, std::uint32_t number);

/// The name of a component of a wrench if `name` is its indexed name: "hand_tx" for "hand[1]";
/// otherwise `name`.
[[nodiscard]] std::string component_name(const Model& model, const std::string& name);

/// The identifier for a name: keeps word characters and replaces "[" by "_". "q[3]" -> "q_3".
[[nodiscard]] std::string identifier_of(std::string_view name);

/// The number of leaves of a kind.
[[nodiscard]] std::size_t leaf_count(const Model& model, Opcode kind);

/// The unit of the entry that owns the leaf, not of the leaf itself; none if the entry has none.
[[nodiscard]] std::optional<Unit> declared_unit(const Model& model, Opcode kind,
                                                std::uint32_t number);

/// The declared range of a leaf; none if no range is declared.
[[nodiscard]] std::optional<Interval> declared_range(const Model& model, Opcode kind,
                                                     std::uint32_t number);

/// The result of draw() for every leaf that has a name, in order; 0 for other leaves.
template <class Draw>
[[nodiscard]] auto sample_leaves(const LeafNames& leaves, const Draw& draw) {
  return map_leaves(
      [&draw](const std::string& name) { return name.empty() ? decltype(draw()){} : draw(); },
      leaves);
}

}  // namespace elgen
