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

/// Roots of the equations of motion: energies, masses, points, bodies, frames, forces and
/// constraints. Names in them are not followed.
[[nodiscard]] std::vector<ExpressionId> equation_roots(const Model& model);

/// Roots of an [[output]].
[[nodiscard]] std::vector<ExpressionId> output_roots(const UserOutput& output);

/// Roots of the equations of motion and of every [[output]].
[[nodiscard]] std::vector<ExpressionId> all_roots(const Model& model);

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
