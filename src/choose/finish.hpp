// finish: the last passes over a function, whose results no algebra may see.
#pragma once

#include "elgen/program.hpp"

namespace elgen {

/// The field of forward_dynamics that is consumed by with_guarded_pivots and never emitted.
inline constexpr std::string_view diagonal_field = "diagonal";

/// Others stay as they are.
[[nodiscard]] Function without_diagonal(Function function);

/// A relative pivot D_i/M_ii is not a number where M_ii is 0.
///
///     before    relative_pivots 2 = 1                  diagonal 2 = m r^2
///     after     relative_pivots 2 = 1 + 0/(m r^2)      or 1 + 0*r where r = 1/(m r^2) is there
///
/// Algebra cancels what D_i and M_ii share, and with it the state where both vanish and M is
/// singular. 0/M_ii puts it back: exactly 0 elsewhere, and neither a branch nor an order of
/// scalars. A reciprocal that is infinite (M_ii below 1/4 of the smallest normal number) is not a
/// number either, as it is in the acceleration. `constants` may grow by 0. Pages leave guards out.
[[nodiscard]] Function with_guarded_pivots(Function forward_dynamics,
                                           std::vector<Constant>& constants);

/// Quaternions divided by their lengths, for any size of their components.
///
///     before    w/sqrt(w^2 + x^2 + y^2 + z^2), …             (right on paper; 1e-160 squared is 0)
///     after     r = w/s, …   r/sqrt(r^2 + …), …   with s = |w| + |x| + |y| + |z|
///
/// Scales quaternions of `normalized`, and of the field `name` of `dynamics` that repeats it.
/// Entries that are no coordinates are components of quaternions, four in a row.
[[nodiscard]] Function with_scaled_lengths(Function function, const std::string& name);

/// The same instructions in an order in which sines and cosines come before all else, with what
/// they need, the two of an angle beside each other; all else in its old order.
///
///     before    0 = m  1 = l  2 = multiply 0 1  3 = q  4 = cos 3  5 = sin 3  6 = multiply 2 5
///     after     0 = q  1 = sin 0  2 = cos 0  3 = m  4 = l  5 = multiply 3 4  6 = multiply 5 1
///
/// A call keeps no floating-point register: what is computed before it has to be stored and loaded
/// again.
[[nodiscard]] Function trigonometry_first(const Function& function);

}  // namespace elgen
