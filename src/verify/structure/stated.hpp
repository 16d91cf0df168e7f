// Stated equations of motion: the difference of a wrong equation from the right ones, and whether
// all equations determine the accelerations. Stated numbers: an [[expect]] `at` a state, such as a
// published table, compared with the oracle.
#pragma once

#include <string>
#include <vector>

#include "verify/structure/expectations.hpp"
#include "verify/structure/proofs.hpp"

namespace elgen {

/// The difference of left - right from the right form with the fewest differing terms. A right form
/// is f times a row of M a + bias - B u, f without velocities, accelerations and inputs. Another is
/// the form with the same accelerations that vanishes along the motion. "compared with row theta of
/// the equations of motion, times 1/(m*l^2): the term g*sin(theta)/l has the other sign"; "" if
/// there are no forms, as with constraints, or if none is near.
[[nodiscard]] std::string difference_from_motion(const Proofs& proofs, const Fraction& equation);

/// The difference from a quantity that is constant at u = 0 and has another factor in one term:
/// "compared with a conserved quantity: the term m*g*l*cos(theta) has the other sign"; "" if there
/// is none, or if the sum contains momenta.
[[nodiscard]] std::string difference_from_conserved(const Proofs& proofs, const Fraction& written);

/// Adds a row for the rank of d(left - right)/da above the rows of A, at states with the
/// accelerations of the motion. E540 if the rank is less than the number of velocities, or if
/// another acceleration also meets all equations.
void check_rank(ExpectationReport& report, const Expectation& equations, const Subject& subject,
                const std::vector<State>& motions);

/// Adds a row for each entry; its error may be `within` of the largest entry of its field. E510 for
/// each entry with a larger error or without a value.
void check_numbers(ExpectationReport& report, const Expectation& expectation,
                   const Subject& subject);

}  // namespace elgen
