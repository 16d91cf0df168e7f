// compose: derivatives of the accelerations, and the linearization, by linear algebra.
//
//     r(q, v, a, u) = M a + bias - B u,   M = L D L^T
//     a = M^-1 (B u - bias)
//     da/dx = -M^-1 dr/dx at that a,   da/du = M^-1 B
//
// M is factorised once. Each column of the right-hand sides needs one forward and one backward
// substitution, which skip the zeros of L. The substitutions are the repetitions of the function
// (Repetition in elgen/program.hpp); emitted code runs them as a loop over the columns.
//
// For each of these outputs, the stage derive makes a function that computes the parts: M and the
// right-hand sides of these equations. compose_outputs() turns this function into the output.
#pragma once

#include "elgen/program.hpp"

namespace elgen {

/// Fields of a function that computes the parts of an output, in this order: M; B u - bias; -dr/dq;
/// -dr/dv; B if the model has inputs; the rows of A for dq/dt if the output is `linearization`. All
/// fields except these rows of A have one row per velocity. The function takes `a` as an argument.
inline constexpr std::string_view mass_part = "mass";
inline constexpr std::string_view force_part = "force";
inline constexpr std::string_view position_part = "by_position";
inline constexpr std::string_view velocity_part = "by_velocity";
inline constexpr std::string_view input_part = "by_input";
inline constexpr std::string_view rate_part = "rates";

/// The least number of velocities at which the derivatives of the accelerations and the
/// linearization are composed. For models with fewer velocities or with constraints, the stage
/// derive makes the functions of these outputs directly.
inline constexpr std::size_t min_composed_velocities = 10;

/// Returns `program` after each function that computes parts (mass_part, …) is replaced by a
/// function that computes the output from these parts.
[[nodiscard]] Program compose_outputs(Program program);

}  // namespace elgen
