// analytic: the values that are no analytic function of what they are made of.
//
//     before    1 = multiply 0 0   2 = square_root 1   3 = subtract 2 0      sqrt(x^2) - x
//     unknowns        .                  *                   .              0 for x > 0 only
//
// A real-analytic function on a connected domain that is zero near one point is zero. Roots, angles
// and kinks break that rule: sqrt(x^2) is x on one side and -x on the other. Each value belongs to
// one of these classes:
//
//     positive   analytic at every real state, and above 0
//     smooth     analytic at every real state
//     analytic   made of smooth values by operations that have poles: 1/x, tan(x), exp(1/x)
//     unknown    anything else: sqrt, log, atan2 of what may not be positive, asin, abs, max, ...
//
// The poles of a meromorphic function do not disconnect its complex domain; a root of one (below
// which x = 0 divides: sqrt(1 + 1/x^2)*x) may have another branch behind each pole, so that roots
// are taken of positive values only. An unknown is a variable of its own, and smooth as such.
#pragma once

#include <vector>

#include "elgen/program.hpp"

namespace elgen {

/// Whether each instruction's value is an unknown. Parameters are positive where their assumption
/// says so; ranges and values make nothing positive. Cost: one pass.
[[nodiscard]] std::vector<bool> unknowns(const Program& program, const Function& function);

}  // namespace elgen
