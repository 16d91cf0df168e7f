// Vanishing: finds the values of a function that are 0 at random points.
#pragma once

#include <vector>

#include "elgen/program.hpp"

namespace elgen {

/// Instructions that vanish at one random point, in 64 digits: the value is below 1e-40 of its
/// error bound E, and 1e-40 E is below 1e-20 of the operands. Leaves are excluded, and so are
/// operands of values that are undefined there. These are candidates only: a root may have another
/// sign elsewhere.
[[nodiscard]] std::vector<std::uint32_t> vanishing(const Program& program,
                                                   const Function& function);

/// For each entry, in the order of the fields: true if it also vanishes at the other points,
/// `zero_sample_count` in all, with random numbers for values that are not analytic
/// (program/network/analytic.hpp). It is then 0 at every state.
[[nodiscard]] std::vector<bool> vanishing_elsewhere(const Program& program,
                                                    const Function& function);

}  // namespace elgen
