// Checks of oracles; each function is called inside a TEST_CASE.
#pragma once

#include "independent/robot.hpp"

namespace elgen::test {

/// Compares M, bias and torque at every state, relative to the largest entry of the reference.
void check_agreement(const Oracle& oracle, const Oracle& reference,
                     const std::vector<State>& states, double tolerance);

/// The reference has 12 printed digits; its entries may be 100 times smaller than the largest.
void check_reference_values(const Oracle& oracle, const ReferenceValues& reference);

}  // namespace elgen::test
