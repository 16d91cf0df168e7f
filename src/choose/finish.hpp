// finish: the last passes over a function. No algebraic pass may follow, because algebra would
// simplify the changes away.
#pragma once

#include "elgen/program.hpp"

namespace elgen {

/// The field of forward_dynamics that with_guarded_pivots consumes; it is never emitted.
inline constexpr std::string_view diagonal_field = "diagonal";

/// `function` without its field `diagonal_field`, if it has this field.
[[nodiscard]] Function without_diagonal(Function function);

/// Makes a relative pivot D_i/M_ii NaN if M_ii is 0.
///
///     before    relative_pivots 2 = 1                  diagonal 2 = m r^2
///     after     relative_pivots 2 = 1 + 0/(m r^2)      or 1 + 0*s if s = 1/(m r^2) exists
///
/// Algebra cancels common factors of D_i and M_ii, and with them the state at which both vanish and
/// M is singular. 0/M_ii restores this state. Elsewhere 0/M_ii is exactly 0, and it needs neither a
/// branch nor a comparison of scalars. If the reciprocal is infinite (M_ii below 1/4 of the
/// smallest normal number), the result is NaN, as in the acceleration. Adds the constant 0 to
/// `constants` if missing. Pages omit guards.
[[nodiscard]] Function with_guarded_pivots(Function forward_dynamics,
                                           std::vector<Constant>& constants);

/// Divides quaternions by their lengths, for components of any magnitude.
///
///     before    w/sqrt(w^2 + x^2 + y^2 + z^2), …             1e-160 squared underflows
///     after     r = w/s, …   r/sqrt(r^2 + …), …   with s = |w| + |x| + |y| + |z|
///
/// Scales the quaternions of `normalized` and of its copy, the field `name` of `dynamics`. Entries
/// that are not coordinates are components of quaternions, four in a row.
[[nodiscard]] Function with_scaled_lengths(Function function, const std::string& name);

/// Reorders instructions: first sines and cosines with their operands, both calls of an angle
/// adjacent, then all other instructions in their old order.
///
///     before    0 = m  1 = l  2 = multiply 0 1  3 = q  4 = cos 3  5 = sin 3  6 = multiply 2 5
///     after     0 = q  1 = sin 0  2 = cos 0  3 = m  4 = l  5 = multiply 3 4  6 = multiply 5 1
///
/// A call preserves no floating-point register, so earlier results would have to be stored and
/// loaded again.
[[nodiscard]] Function with_trigonometry_first(const Function& function);

}  // namespace elgen
