// solution: the accelerations and multipliers that end a derivation.
#pragma once

#include <string>
#include <vector>

#include "elgen/page.hpp"

namespace elgen {

/// The entries of forward dynamics that are short enough for paper, one field for each.
struct PaperSolution {
  FunctionEquations equations = {};
  Formulas left = {};  ///< the acceleration or multiplier of each field of `equations`
  std::vector<std::string> omitted = {};  ///< names of the other accelerations and multipliers
};

/// Selects the accelerations and multipliers that have at most 12 lines of 78 columns each, and so
/// have the definitions that they contain. The selection is the same in every notation.
[[nodiscard]] PaperSolution solution_on_paper(const Model& model, const Program& forward_dynamics);

}  // namespace elgen
