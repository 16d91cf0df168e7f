// References: the expressions, entries and leaves to which an expression of a Model refers, by its
// operands and by names.
#pragma once

#include <optional>
#include <vector>

#include "elgen/model.hpp"

namespace elgen {

/// For an expression of kind `named`: the expression that the name stands for, that is, a
/// prescribed function, a definition, or a component of a point, a body or a frame. None for other
/// expressions.
[[nodiscard]] std::optional<ExpressionId> value_of_name(const Model& model,
                                                        const Expression& expression);

/// The operands of `expression`; for a name, the expression that the name stands for.
[[nodiscard]] std::vector<ExpressionId> references(const Model& model, ExpressionId expression);

enum class EntityKind : std::uint8_t {
  definition,
  prescribed,
  point,
  frame,
  body,
  coordinate,
  gravity,
  energy,
  force,
  constraint,
  output
};

/// An entry of the model, by kind and index.
struct Entity {
  EntityKind kind = EntityKind::energy;
  std::uint32_t index = 0;

  bool operator==(const Entity&) const = default;
};

/// The role of an expression in its entry.
enum class RootRole : std::uint8_t {
  value,  ///< value of a definition, prescribed function, gravity, force, constraint or output
  armature,
  rotation,
  place,  ///< position of a point, of a centre of mass, or of the origin of a frame
  spin,
  mass,
  inertia,
  kinetic,
  potential,
  dissipation,
  lagrangian,
  reaction,
  omega,
  zeta,
  twist
};

/// An expression in an entry of the model, and the role of the expression in this entry.
struct Root {
  ExpressionId expression = 0;
  Entity entity = {};
  RootRole role = RootRole::value;
};

/// The expressions that entries contain, entry by entry: first the equations of motion, then
/// outputs, then definitions and prescribed functions. References are not followed. The list omits
/// duplicates (transforms of frames, positions in frame axes, forces as declared), claims about the
/// model (stated points, expected closed forms) and laws of inputs.
[[nodiscard]] std::vector<Root> roots_of(const Model& model);

/// The expressions of the roots for which `is_wanted` is true, in the order of roots_of().
template <class Condition>
[[nodiscard]] std::vector<ExpressionId> filter_roots(const Model& model,
                                                     const Condition& is_wanted) {
  std::vector<ExpressionId> wanted;
  for (const Root& root : roots_of(model)) {
    if (is_wanted(root)) wanted.push_back(root.expression);
  }
  return wanted;
}

/// The roots of the equations of motion: energies, masses, points, bodies, frames, forces and
/// constraints.
[[nodiscard]] std::vector<ExpressionId> equation_roots(const Model& model);

/// The roots of one [[output]].
[[nodiscard]] std::vector<ExpressionId> output_roots(const Model& model, std::uint32_t output);

/// The roots of the equations of motion and of every [[output]].
[[nodiscard]] std::vector<ExpressionId> equation_and_output_roots(const Model& model);

/// True if the root is the value of a force.
[[nodiscard]] inline bool is_force_value(const Root& root) {
  return root.entity.kind == EntityKind::force && root.role == RootRole::value;
}

/// True if the root is the dissipation D.
[[nodiscard]] inline bool is_dissipation(const Root& root) {
  return root.role == RootRole::dissipation;
}

/// The dissipation D as a root; empty if the model has none.
[[nodiscard]] inline std::vector<ExpressionId> dissipation_roots(const Model& model) {
  return filter_roots(model, is_dissipation);
}

/// The expressions that determine the work of a force: the positions of its points and the angular
/// velocities of its frames.
[[nodiscard]] std::vector<ExpressionId> work_expressions(const Model& model, const Force& force);

/// The roots and all expressions that they refer to, directly or indirectly, each once, operands
/// before their users. The model must be free of cycles. Cost: linear in the number of expressions.
[[nodiscard]] std::vector<ExpressionId> reachable_expressions(
    const Model& model, const std::vector<ExpressionId>& roots);

/// True if the expression contains a leaf of these kinds, also through names.
[[nodiscard]] bool contains_leaf(const Model& model, ExpressionId expression, LeafSet kinds);

/// True if the expression is constant along a run: it contains neither q, v nor t. A law that is
/// constant along a run is not clamped to limits.
[[nodiscard]] bool is_constant_along_run(const Model& model, ExpressionId expression);

/// True if the roots contain the coordinate, its rate or its acceleration, also through names.
[[nodiscard]] bool contains_variable(const Model& model, const std::vector<ExpressionId>& roots,
                                     const HeldCoordinate& variable);

/// All expressions of a model without cycles, each after the expressions that it refers to.
[[nodiscard]] std::vector<ExpressionId> topological_order(const Model& model);

/// A cycle of references: each expression refers to the next, the last to the first. A component of
/// a point or frame counts as a reference to all its components. Empty if the model has no cycle.
[[nodiscard]] std::vector<ExpressionId> find_cycle(const Model& model);

}  // namespace elgen
