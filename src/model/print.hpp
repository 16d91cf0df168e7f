// print: expressions of a Model as formulas, in the language of a spelling.
#pragma once

#include <functional>

#include "elgen/model.hpp"
#include "model/formula.hpp"

namespace elgen {

/// With as few brackets as keep the tree. `name` writes what has a name: leaves, pi, definitions,
/// components of points and frames, and rates.
[[nodiscard]] Formula formula_of(const Model& model, ExpressionId expression,
                                 const Spelling& spelling,
                                 const std::function<Formula(ExpressionId)>& name);

}  // namespace elgen
