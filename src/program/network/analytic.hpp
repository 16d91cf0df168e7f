// analytic: finds values that are no analytic function of their operands.
//
//     before    1 = multiply 0 0   2 = square_root 1   3 = subtract 2 0      sqrt(x^2) - x
//     unknowns        .                  *                   .              0 for x > 0 only
//
// A real-analytic function on a connected domain that is zero near one point is zero. Roots, angles
// and kinks break this rule: sqrt(x^2) is x for x > 0 and -x for x < 0. Each value has one of these
// classes:
//
//     positive   analytic at every real state, and above 0
//     smooth     analytic at every real state
//     analytic   smooth values combined by operations that have poles: 1/x, tan(x), exp(1/x)
//     unknown    anything else: sqrt, log, atan2 of values that may be <= 0, asin, abs, max, ...
//
// The poles of a meromorphic function do not disconnect its complex domain. A root of the function
// may have another branch behind each pole (sqrt(1 + 1/x^2)*x at x = 0), so only roots of positive
// values are smooth. An unknown counts as a new variable, which is smooth.
#pragma once

#include <vector>

#include "elgen/program.hpp"

namespace elgen {

/// True for each instruction whose value is unknown. A parameter is positive only by assumption,
/// not by its range or value. Cost: one pass.
[[nodiscard]] std::vector<bool> mark_unknown_values(const Program& program,
                                                    const Function& function);

}  // namespace elgen
