// Checks of oracles; each function is called inside a TEST_CASE.
#pragma once

#include "independent/robot.hpp"

namespace elgen::test {

/// Compares M, bias and torque at every state, relative to the largest entry of the reference.
void check_agreement(const Oracle& oracle, const Oracle& reference,
                     const std::vector<State>& states, double tolerance);

/// Compares torque, gravity and the first row of M with `reference`, to 1e-11 of the largest entry.
void check_reference_values(const Oracle& oracle, const ReferenceValues& reference);

}  // namespace elgen::test
