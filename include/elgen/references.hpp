// References: the expressions, entries and leaves to which expressions of a Model refer.
#pragma once

#include <optional>
#include <vector>

#include "elgen/model.hpp"

namespace elgen {

/// The expression that a name refers to: a prescribed function, a definition, or a component of a
/// point, a body or a frame. None if the expression is no such name.
[[nodiscard]] std::optional<ExpressionId> value_of_name(const Model& model,
                                                        const Expression& expression);

/// The operands of an expression, or the expression that its name refers to.
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
};

/// The role of an expression in its entry.
enum class RootRole : std::uint8_t {
  value,  ///< of a definition, prescribed function, gravity, force, constraint or output
  armature,
  rotation,
  place,  ///< of a point, a centre of mass, or the origin of a frame
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

/// An expression in an entry of the model.
struct Root {
  ExpressionId expression = 0;
  Entity entity = {};
  RootRole role = RootRole::value;
};

/// The expressions of all entries, by entry: first of the equations, then of outputs, then of
/// definitions and prescribed functions. References are not followed. Omitted are duplicates (steps
/// of frames, places in frame axes, forces as declared) and claims about the model (stated points,
/// closed forms, laws of inputs).
[[nodiscard]] std::vector<Root> roots_of(const Model& model);

/// The expressions of the roots for which `is_wanted` is true, in the order of roots_of().
template <class Condition>
[[nodiscard]] std::vector<ExpressionId> roots_if(const Model& model, const Condition& is_wanted) {
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
[[nodiscard]] std::vector<ExpressionId> all_roots(const Model& model);

/// True for the value of a force.
[[nodiscard]] inline bool is_force(const Root& root) {
  return root.entity.kind == EntityKind::force && root.role == RootRole::value;
}

/// True for D.
[[nodiscard]] inline bool is_dissipation(const Root& root) {
  return root.role == RootRole::dissipation;
}

/// The root of D, if the model has D.
[[nodiscard]] inline std::vector<ExpressionId> dissipation_roots(const Model& model) {
  return roots_if(model, is_dissipation);
}

/// The expressions along which a force does work: the positions of its points and the spins of its
/// frames.
[[nodiscard]] std::vector<ExpressionId> work_expressions(const Model& model, const Force& force);

/// The roots and all expressions that they refer to, each once, operands before their users. The
/// model must be free of cycles. Cost: one visit per expression.
[[nodiscard]] std::vector<ExpressionId> reachable_from(const Model& model,
                                                       const std::vector<ExpressionId>& roots);

/// True if the expression contains a leaf of these kinds, directly or by reference.
[[nodiscard]] bool contains_leaf(const Model& model, ExpressionId expression, LeafSet kinds);

/// True if the roots contain the coordinate, its rate or its acceleration, directly or by
/// reference.
[[nodiscard]] bool contains_variable(const Model& model, const std::vector<ExpressionId>& roots,
                                     const Held& variable);

/// Every expression of a model without cycles, after the expressions that it refers to.
[[nodiscard]] std::vector<ExpressionId> topological_order(const Model& model);

/// A cycle: each expression refers to the next, the last one to the first. A component of a point
/// or frame counts as a reference to all its components. Empty if there is no cycle.
[[nodiscard]] std::vector<ExpressionId> find_cycle(const Model& model);

}  // namespace elgen
