// angle_groups: the sines and cosines of a Function that code can compute together.
//
//     1 = sin 0; 3 = cos 2; 5 = add 1 3; 6 = sin 5      groups {1, 3}; 6 is alone
#pragma once

#include <cstdint>
#include <vector>

#include "elgen/program.hpp"

namespace elgen {

/// Calls of sin and cos that do not depend on each other, with at least two different angles. Calls
/// with the same angle are neighbours. Angles are in the order of evaluation.
using AngleGroup = std::vector<std::uint32_t>;

/// Calls with equally deep nesting of sines in their angles, and with equal `is_inner`, are in one
/// group. Instructions of the loop over columns are in no group.
[[nodiscard]] std::vector<AngleGroup> angle_groups(const Function& function);

/// True if some function has a group.
[[nodiscard]] bool has_angle_groups(const Program& program);

}  // namespace elgen
