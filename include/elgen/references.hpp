// References: what the expressions of a Model are made of, through its names.
#pragma once

#include <optional>
#include <vector>

#include "elgen/model.hpp"

namespace elgen {

/// The expression that a name stands for: that of a prescribed function, a definition, or a
/// component of a point, a body or a frame. None where the expression is no such name.
[[nodiscard]] std::optional<ExpressionId> value_of_name(const Model& model,
                                                        const Expression& expression);

/// The references of an expression: its operands, or the expression that its name stands for.
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

/// An entry of the model.
struct Entity {
  EntityKind kind = EntityKind::energy;
  std::uint32_t index = 0;
};

/// The role of an expression in its entry.
enum class RootRole : std::uint8_t {
  value,  ///< of a name, gravity, a force, a constraint or an output
  armature,
  rotation,
  place,  ///< of a point, a centre of mass or the origin of a frame
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

/// An expression that an entry holds.
struct Root {
  ExpressionId expression = 0;
  Entity entity = {};
  RootRole role = RootRole::value;
};

/// The expressions of all entries that equations, outputs and names are made of, by entry: first
/// those of the equations, then those of outputs, then those of names. Names are not followed.
/// Left out are expressions that repeat others (steps of frames, places in their axes, forces as
/// written) and those that ask about the model (stated points, closed forms, laws of inputs).
[[nodiscard]] std::vector<Root> roots_of(const Model& model);

/// The expressions of the roots that meet a condition, in the order of roots_of().
template <class Condition>
[[nodiscard]] std::vector<ExpressionId> roots_if(const Model& model, const Condition& is_wanted) {
  std::vector<ExpressionId> wanted;
  for (const Root& root : roots_of(model)) {
    if (is_wanted(root)) wanted.push_back(root.expression);
  }
  return wanted;
}

/// Roots of the equations of motion: energies, masses, points, bodies, frames, forces and
/// constraints.
[[nodiscard]] std::vector<ExpressionId> equation_roots(const Model& model);

/// Roots of an [[output]].
[[nodiscard]] std::vector<ExpressionId> output_roots(const Model& model, std::uint32_t output);

/// Roots of the equations of motion and of every [[output]].
[[nodiscard]] std::vector<ExpressionId> all_roots(const Model& model);

/// The values of forces.
[[nodiscard]] inline bool is_force(const Root& root) {
  return root.entity.kind == EntityKind::force && root.role == RootRole::value;
}

/// D.
[[nodiscard]] inline bool is_dissipation(const Root& root) {
  return root.role == RootRole::dissipation;
}

/// The roots that D is made of.
[[nodiscard]] inline std::vector<ExpressionId> dissipation_roots(const Model& model) {
  return roots_if(model, is_dissipation);
}

/// A force does work along these: the places of its points and the spins of its frames.
[[nodiscard]] std::vector<ExpressionId> moved_by(const Model& model, const Force& force);

/// The roots and everything below them, each once, operands before their users, in a model without
/// cycles. Cost: one visit per expression.
[[nodiscard]] std::vector<ExpressionId> reached(const Model& model,
                                                const std::vector<ExpressionId>& roots);

/// Whether an expression, or what it refers to, is a leaf of one of these kinds.
[[nodiscard]] bool holds_leaf(const Model& model, ExpressionId expression, LeafSet kinds);

/// Whether a coordinate, its rate or its acceleration stands below the roots.
[[nodiscard]] bool is_reached(const Model& model, const std::vector<ExpressionId>& roots,
                              const Held& variable);

/// Every expression of a model without cycles, each after what it refers to.
[[nodiscard]] std::vector<ExpressionId> in_order(const Model& model);

/// Expressions of which each refers to the next and the last to the first, where a component stands
/// for all of its point or frame. Empty where there are none.
[[nodiscard]] std::vector<ExpressionId> find_cycle(const Model& model);

}  // namespace elgen
