// Roots: the expressions that equations and outputs are made of.
#pragma once

#include <vector>

#include "elgen/model.hpp"

namespace elgen {

/// Roots of the equations of motion: energies, masses, points, bodies, frames, forces and
/// constraints. Names in them are not followed.
[[nodiscard]] std::vector<ExpressionId> equation_roots(const Model& model);

/// Roots of an [[output]].
[[nodiscard]] std::vector<ExpressionId> output_roots(const UserOutput& output);

}  // namespace elgen
