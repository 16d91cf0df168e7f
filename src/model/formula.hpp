// formula: expressions of a Model as trees, operand by operand.
//
//     multiply(1/2, add(a, negate(b)))   ->   1/2*(a - b)
#pragma once

#include <functional>

#include "elgen/formula.hpp"
#include "elgen/model.hpp"

namespace elgen {

/// `name` gives what has a name: leaves, pi, definitions, components of points and frames, and
/// rates.
[[nodiscard]] Formula formula_of(const Model& model, ExpressionId expression,
                                 const std::function<Formula(ExpressionId)>& name);

}  // namespace elgen
