// Checks of oracles; each function is called inside a TEST_CASE.
#pragma once

#include "independent/robot.hpp"

namespace elgen::test {

/// M, bias and torque at every state, relative to the largest entry of the reference.
void check_agreement(const Oracle& oracle, const Oracle& reference,
                     const std::vector<State>& states, double tolerance);

/// 12 printed digits, of entries that are up to 100 times smaller than the largest.
void check_reference_values(const Oracle& oracle, const ReferenceValues& reference);

}  // namespace elgen::test
