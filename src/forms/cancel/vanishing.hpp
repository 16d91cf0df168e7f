// Vanishing: finds the values of a function that are 0 at random points.
#pragma once

#include <vector>

#include "elgen/program.hpp"

namespace elgen {

/// The indices of the instructions whose value is 0 at one random point (sampled_values.hpp).
/// Leaves are excluded, and so are operands of values that are undefined at this point. A value
/// that vanishes here need not vanish elsewhere: a root may have another sign there.
[[nodiscard]] std::vector<std::uint32_t> find_vanishing_values(const Program& program,
                                                               const Function& function);

/// For each entry, in the order of the fields: true if the entry vanishes at the other
/// `zero_sample_count` - 1 random points. Random numbers replace values that are not analytic
/// (program/network/analytic.hpp). An entry that vanishes at all points is 0 at every state.
[[nodiscard]] std::vector<bool> find_vanishing_entries(const Program& program,
                                                       const Function& function);

}  // namespace elgen
