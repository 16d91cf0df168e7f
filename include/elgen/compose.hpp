// compose: derivatives of the accelerations, and the linearization, by linear algebra.
//
//     r(q, v, a, u) = M a + bias - B u,   M = L D L^T
//     a = M^-1 (B u - bias)
//     da/dx = -M^-1 dr/dx at that a,   da/du = M^-1 B
//
// M is factorised once. Each column of the right-hand sides needs one forward and one backward
// substitution, which skip the zeros of L. These are the repetitions of the function
// (elgen/program.hpp), which code runs as a loop over columns.
#pragma once

#include "elgen/program.hpp"

namespace elgen {

/// Fields of a function of parts, in this order: M; B u - bias; -dr/dq; -dr/dv; B if the model has
/// inputs; the upper rows of A for `linearization`. Rows are velocities; `a` is an argument.
inline constexpr std::string_view mass_part = "mass";
inline constexpr std::string_view force_part = "force";
inline constexpr std::string_view position_part = "by_position";
inline constexpr std::string_view velocity_part = "by_velocity";
inline constexpr std::string_view input_part = "by_input";
inline constexpr std::string_view rate_part = "rates";

/// From this number of velocities on, these outputs are composed. With fewer velocities they are
/// written out and have closed forms.
inline constexpr std::size_t min_composed_velocities = 10;

/// The same program; every function of parts is replaced by its output.
[[nodiscard]] Program compose_outputs(Program program);

}  // namespace elgen
