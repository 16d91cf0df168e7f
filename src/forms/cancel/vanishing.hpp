// Vanishing: the values of a function that are zero wherever one looks.
#pragma once

#include <vector>

#include "elgen/program.hpp"

namespace elgen {

/// The instructions below 1e-40 of their bound at one random point, in 60 digits, where that is
/// below 1e-20 of their terms; leaves do not count, nor what goes into a value that is undefined
/// there. Candidates only: a root may have another sign elsewhere.
[[nodiscard]] std::vector<std::uint32_t> vanishing(const Program& program,
                                                   const Function& function);

/// Whether every entry, in the order of the fields, is so at as many points more as make it
/// `zero_points`, whatever the values are that are not analytic (program/network/analytic.hpp):
/// then it is 0 at every state.
[[nodiscard]] std::vector<bool> vanishing_elsewhere(const Program& program,
                                                    const Function& function);

}  // namespace elgen
