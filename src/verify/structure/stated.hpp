// Stated equations of motion: how a wrong one differs from the right ones, and whether all of them
// determine the accelerations. Stated numbers: an [[expect]] `at` a state, such as a published
// table, judged by the oracle.
#pragma once

#include <string>
#include <vector>

#include "verify/structure/expectations.hpp"
#include "verify/structure/proofs.hpp"

namespace elgen {

/// The difference of left - right from f times a row of M a + bias - B u, f without velocities,
/// accelerations and inputs, where the fewest terms differ; or from what has the same accelerations
/// in it and holds along the motion. "compared with row theta of the equations of motion, times
/// 1/(m*l^2): the term g*sin(theta)/l has the other sign"; "" where there are no forms to compare,
/// as with constraints, or none is near.
[[nodiscard]] std::string difference_from_motion(const Proofs& proofs, const Fraction& equation);

/// The difference from a quantity that is constant at u = 0 and has another factor at one term:
/// "compared with a conserved quantity: the term m*g*l*cos(theta) has the other sign"; "" if there
/// is none, and of sums that hold momenta.
[[nodiscard]] std::string difference_from_conserved(const Proofs& proofs, const Fraction& written);

/// A row for the rank of d(left - right)/da with the rows of A below, at states with the
/// accelerations of the motion. E540 if it is less than the number of velocities, or if another
/// acceleration meets all equations, too.
void check_rank(ExpectationReport& report, const Expectation& equations, const Subject& subject,
                const std::vector<State>& motions);

/// A row for each entry, which may be off by `within` of the largest one of its field; E510 at each
/// that is farther off, or has no value.
void check_numbers(ExpectationReport& report, const Expectation& expectation,
                   const Subject& subject);

}  // namespace elgen
