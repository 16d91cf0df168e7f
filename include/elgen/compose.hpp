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
// The stage derive replaces an output by a "function of parts", whose fields are the matrices of
// the right-hand sides above; compose_outputs() turns it into the output.
#pragma once

#include "elgen/program.hpp"

namespace elgen {

/// Fields of a function of parts, in this order: M; B u - bias; -dr/dq; -dr/dv; B if the model has
/// inputs; for `linearization`, the rows of A for dq/dt. The other fields have one row per
/// velocity. The function takes `a` as an argument.
inline constexpr std::string_view mass_part = "mass";
inline constexpr std::string_view force_part = "force";
inline constexpr std::string_view position_part = "by_position";
inline constexpr std::string_view velocity_part = "by_velocity";
inline constexpr std::string_view input_part = "by_input";
inline constexpr std::string_view rate_part = "rates";

/// Models with at least this number of velocities compose these outputs. For smaller models the
/// outputs are expanded, and have closed forms.
inline constexpr std::size_t min_composed_velocities = 10;

/// The program with every function of parts replaced by its output.
[[nodiscard]] Program compose_outputs(Program program);

}  // namespace elgen
