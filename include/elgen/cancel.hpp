// cancel: replaces values that are identically zero by the constant 0.
//
//     before    0 = parameter m   1 = parameter l   2 = multiply 0 1   3 = …, equal to 2
//               4 = subtract 2 3   5 = velocity q   6 = multiply 4 5   7 = add 6 0     result = 7
//     after     0 = parameter m                                                        result = 0
//
// In a recursive form, terms that cancel symbolically may stay in separate definitions; code then
// computes 1e-14 instead of 0. A value is a candidate if its magnitude at a random point, in 60
// digits, is at most 1e-40 times its error bound. A candidate is replaced if its closed form is the
// empty sum. An analytic candidate (program/network/analytic.hpp) that vanishes at 64 points is
// also replaced; Function::sampled_zeros lists the entries that depend on such candidates.
#pragma once

#include "elgen/program.hpp"

namespace elgen {

/// `program` with every value that is found to be identically zero replaced by 0. Cost: one
/// evaluation of every function in 60 digits; 63 more for each function that has candidates without
/// a proof; and a second lowering of the functions that change.
[[nodiscard]] Program cancel(Program program);

}  // namespace elgen
