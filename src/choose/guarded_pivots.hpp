// guarded_pivots: a relative pivot D_i/M_ii is not a number where M_ii is 0.
//
//     before    relative_pivots 2 = 1                  diagonal 2 = m r^2
//     after     relative_pivots 2 = 1 + 0/(m r^2)
//
// Algebra cancels what D_i and M_ii share, and with it the state where both vanish and M is
// singular. 0/M_ii puts it back: exactly 0 elsewhere, and neither a branch nor an order of scalars.
#pragma once

#include "elgen/program.hpp"

namespace elgen {

/// The field of forward_dynamics that is consumed by with_guarded_pivots and never emitted.
inline constexpr std::string_view diagonal_field = "diagonal";

[[nodiscard]] Function without_diagonal(Function forward_dynamics);
/// `constants` may grow by 0.
[[nodiscard]] Function with_guarded_pivots(Function forward_dynamics,
                                           std::vector<Constant>& constants);

}  // namespace elgen
