// scaled_length: quaternions divided by their lengths, for any size of their components.
//
//     before    w/sqrt(w^2 + x^2 + y^2 + z^2), …             (right on paper; 1e-160 squared is 0)
//     after     r = w/s, …   r/sqrt(r^2 + …), …   with s = |w| + |x| + |y| + |z|
//
// No algebra may see s, which it would cancel: this is the last thing done to the function.
#pragma once

#include "elgen/program.hpp"

namespace elgen {

/// Of `normalized`, and of the field of `dynamics` that repeats it as `name`. What is no coordinate
/// itself is the component of a quaternion, four in a row.
[[nodiscard]] Function with_scaled_lengths(Function function, const std::string& name);

}  // namespace elgen
