// compose: derivatives of the accelerations, and the linearization, from their parts.
//
//     r(q, v, a, u) = M a + bias - B u,   M = L D L^T
//     a = M^-1 (B u - bias)
//     da/dx = -M^-1 dr/dx at that a,   da/du = M^-1 B
//
// M is factorised once. One column of the right-hand sides takes a forward and a backward
// substitution, which leave out the zeros of L: these are the repetitions of the function
// (elgen/program.hpp), which code runs as a loop over columns.
#pragma once

#include "elgen/program.hpp"

namespace elgen {

/// The fields of a function of parts, which takes a too: M; B u - bias; -dr/dq, -dr/dv; where there
/// are inputs B; for `linearization` the upper rows of A. Rows are velocities.
inline constexpr std::string_view mass_part = "mass";
inline constexpr std::string_view force_part = "force";
inline constexpr std::string_view position_part = "by_position";
inline constexpr std::string_view velocity_part = "by_velocity";
inline constexpr std::string_view input_part = "by_input";
inline constexpr std::string_view rate_part = "rates";

/// From this many velocities on, derivatives of accelerations and the linearization are composed.
/// With fewer velocities derivatives are written out and have closed forms.
inline constexpr std::size_t least_of_composed = 10;

/// The same program with outputs in the place of their parts.
[[nodiscard]] Program composed(Program program);

}  // namespace elgen
