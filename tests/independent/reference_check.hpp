// The reference values of a robot, asked of an oracle.
#pragma once

#include "independent/robot.hpp"

namespace elgen::test {

/// In a TEST_CASE: 12 printed digits, of entries that are up to 100 times smaller than the largest.
void check_reference_values(const Oracle& oracle, const ReferenceValues& reference);

}  // namespace elgen::test
