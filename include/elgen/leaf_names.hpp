// The leaves of a Model: what they are called, how many there are, the ranges it declares.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "elgen/leaves.hpp"
#include "elgen/model.hpp"

namespace elgen {

/// f(kind, entry) of the entry of the model that each leaf belongs to; single(kind) of t, h and E.
template <class T, class F, class Single>
[[nodiscard]] LeafValues<T> leaves_of(const Model& model, const F& f, const Single& single) {
  LeafValues<T> leaves;
#define ELGEN_LEAVES(kind, member, of, ...) \
  for (const auto& entry : model.of) leaves.member.push_back(f(Opcode::kind, entry));
#define ELGEN_LEAF(kind, member, ...) leaves.member = single(Opcode::kind);
#include "elgen/leaves.def"
#undef ELGEN_LEAVES
#undef ELGEN_LEAF
  return leaves;
}

/// "m", "l[2]", "theta", "q[1]"; of rates what dot() is written around. Momenta, by the names of
/// their velocities, and h have names in programs with functions that take them, E has none.
struct LeafNames : LeafValues<std::string> {
  bool uses_time = false;
  std::vector<Assumption> assumptions = {};  ///< of the parameters; empty: none
};

[[nodiscard]] Assumption assumption_of(const LeafNames& leaves, std::uint32_t parameter);

[[nodiscard]] LeafNames leaf_names(const Model& model);

/// Gives names to the leaves of taken kinds that have none otherwise: a list is named like the
/// velocities, a single leaf by its symbol.
void name_taken(LeafSet takes, LeafNames& leaves);

/// Whether a coordinate, parameter, input, function, prescribed motion or definition has the name.
[[nodiscard]] bool has_value_named(const Model& model, std::string_view name);

/// The name of the leaf E in `conserved`: `energy_function` where the model calls something else E.
[[nodiscard]] std::string energy_name(const Model& model);

/// "m", "dot(x)", "t": a leaf as models write it.
[[nodiscard]] std::string leaf_text(const LeafNames& leaves, Opcode kind, std::uint32_t number);
[[nodiscard]] std::string leaf_text(const Model& model, Opcode kind, std::uint32_t number);

/// "q[3]" -> "q_3": word characters, and an underscore for an opening bracket.
[[nodiscard]] std::string identifier_of(std::string_view name);

/// How many there are of a kind.
[[nodiscard]] std::size_t leaf_count(const Model& model, Opcode kind);

/// The unit that a model declares for the entry of a leaf, if it does.
[[nodiscard]] std::optional<Unit> declared_unit(const Model& model, Opcode kind,
                                                std::uint32_t number);

/// The range a model declares for a leaf, if it does.
[[nodiscard]] std::optional<Interval> declared_range(const Model& model, Opcode kind,
                                                     std::uint32_t number);

/// draw() for every leaf that has a name, in their order, t among them.
template <class Draw>
[[nodiscard]] auto draw_leaves(const LeafNames& leaves, const Draw& draw) {
  return map_leaves(
      [&draw](const std::string& name) { return name.empty() ? decltype(draw()){} : draw(); },
      leaves);
}

}  // namespace elgen
