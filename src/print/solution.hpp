// solution: the equations that end a derivation: rows, accelerations and multipliers that are short
// enough for paper, which is at most 12 lines of 78 columns. The choice is the same in every
// notation.
#pragma once

#include <string>
#include <vector>

#include "elgen/page.hpp"

namespace elgen {

/// The equations of some entries of program.readable[index], one field for each, with the
/// definitions that these entries need.
[[nodiscard]] FunctionEquations equations_of_entries(const Model& model, const Program& program,
                                                     std::size_t index,
                                                     const std::vector<std::uint32_t>& entries);

/// True if the equation left = first entry, and each definition, is short enough.
[[nodiscard]] bool is_short_on_paper(const Formula& left, const FunctionEquations& equations);

/// The entries of forward dynamics that are short enough for paper, one field for each.
struct PaperSolution {
  FunctionEquations equations = {};
  Formulas left = {};  ///< the acceleration or multiplier of each field of `equations`
  /// The other entries: "accelerations of x, theta", "multipliers of rod".
  std::vector<std::string> omitted = {};
};

[[nodiscard]] PaperSolution solution_on_paper(const Model& model, const Program& forward_dynamics);

}  // namespace elgen
