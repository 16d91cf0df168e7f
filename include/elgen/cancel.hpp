// cancel: what is identically zero becomes exactly 0.
//
//     before    0 = parameter m   1 = parameter l   2 = multiply 0 1   3 = …, the same otherwise
//               4 = subtract 2 3   5 = velocity q   6 = multiply 4 5   7 = add 6 0     result = 7
//     after     0 = parameter m                                                        result = 0
//
// A value that cancels on paper but not in the definitions of a recursion is computed as noise:
// 1e-14 instead of 0. Such a value is found by numbers: at a random point it is below 1e-40 of its
// error bound, in 60 digits. It is 0 where its closed form is the empty sum, or where it is
// analytic and so at 64 points (program/network/analytic.hpp); the entries that rest on points
// alone are kept in Function::sampled_zeros.
#pragma once

#include "elgen/program.hpp"

namespace elgen {

/// Cost: every function once in 60 digits; what vanishes and is not proved to, 63 times more; and
/// functions that change are lowered again.
[[nodiscard]] Program cancel(Program program);

}  // namespace elgen
