// Roots: the expressions that equations and outputs are made of.
#pragma once

#include <vector>

#include "elgen/model.hpp"

namespace elgen::inspection {

/// Of the equations of motion: energies, masses, points, bodies, frames and forces. Names in them
/// are not followed.
[[nodiscard]] std::vector<ExpressionId> equation_roots(const Model& model);

/// Of an [[output]].
[[nodiscard]] std::vector<ExpressionId> output_roots(const UserOutput& output);

/// What an expression refers to: its operands, or the one that its name stands for.
[[nodiscard]] std::vector<ExpressionId> referred_to(const Model& model, ExpressionId expression);

/// Everything below the roots, through names, each once, operands before their users.
[[nodiscard]] std::vector<ExpressionId> below(const Model& model,
                                              const std::vector<ExpressionId>& roots);

}  // namespace elgen::inspection
