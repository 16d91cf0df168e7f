// Contractions: one number w.x of a column x, or w.X y of a matrix X, from a few directional
// derivatives.
#pragma once

#include "elgen/outputs.hpp"
#include "mechanics.hpp"

namespace elgen::oracle {

/// The outputs that are columns of directional derivatives: forces and the momentum.
[[nodiscard]] bool is_contractible_column(OutputKind kind);

/// The outputs that are matrices of directional derivatives: M, C, B.
[[nodiscard]] bool is_contractible_matrix(OutputKind kind);

/// w.([v]x M y + [y]x M v + M [v]x y) on the velocities of rotations, v the state's.
[[nodiscard]] cln::cl_R turning(Mechanics& at, const Direction& w, const Direction& y);

/// w.x; the output must be a contractible column.
[[nodiscard]] cln::cl_R contracted_column(OutputKind kind, Mechanics& at, const Direction& w);

/// w.X y; the output must be a contractible matrix. y has as many entries as X has columns.
[[nodiscard]] cln::cl_R contracted_matrix(OutputKind kind, Mechanics& at, const Direction& w,
                                          const Direction& y);

}  // namespace elgen::oracle
