// trigonometry_first: the order of evaluation in which the sines and cosines of a function come
// before all else, with what they need, the two of an angle beside each other.
//
//     before    0 = m   1 = l   2 = multiply 0 1   3 = q   4 = cos 3   5 = sin 3   6 = multiply 2 5
//     after     0 = q   1 = sin 0   2 = cos 0   3 = m   4 = l   5 = multiply 3 4   6 = multiply 5 1
//
// A call keeps no floating-point register: what is computed before it has to be stored and loaded
// again.
#pragma once

#include "elgen/program.hpp"

namespace elgen {

/// The same instructions with the same names, all else in its old order.
[[nodiscard]] Function trigonometry_first(const Function& function);

}  // namespace elgen
