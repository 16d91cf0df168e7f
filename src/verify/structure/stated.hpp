// Expected equations of motion: in which terms a wrong equation differs from the right one, and
// whether all equations determine the accelerations. Expected numbers: an [[expect]] `at` a state,
// such as a published table, compared with the oracle.
#pragma once

#include <string>
#include <vector>

#include "verify/structure/expectations.hpp"
#include "verify/structure/proofs.hpp"

namespace elgen {

/// In which terms `equation`, left - right, differs from the nearest right form, the right form
/// with the fewest differing terms. Right forms: f times a row of M a + bias - B u, f free of
/// velocities, accelerations and inputs; and `equation` minus its value along the motion. "compared
/// with row theta of the equations of motion, times 1/(m*l^2): the term g*sin(theta)/l has the
/// opposite sign". If too many terms differ: "left - right is m*g along the motion". "" if this
/// text is too long, if there are no closed forms, or if the model has constraints.
[[nodiscard]] std::string difference_from_motion(const ExpectationProver& proofs,
                                                 const Fraction& equation);

/// Names the term in which `written` differs from a quantity that is constant at u = 0: "compared
/// with a conserved quantity: the term m*g*l*cos(theta) has the opposite sign". "" if no change of
/// one term's factor makes `written` constant, or if it contains momenta.
[[nodiscard]] std::string difference_from_constant(const ExpectationProver& proofs,
                                                   const Fraction& written);

/// Adds a row for the rank of d(left - right)/da together with the rows of A, at `motions`, states
/// with the accelerations of the motion. E540 if the rank is less than the number of velocities, or
/// if another acceleration also satisfies all equations.
void check_rank(ExpectationReport& report, const Expectation& equations,
                const SystemUnderTest& subject, const std::vector<State>& motions);

/// Adds a row for each entry of an expectation `at` a state. E510 for each entry without a value,
/// or with an error larger than the expectation's tolerance times the largest entry of its field.
void check_numbers(ExpectationReport& report, const Expectation& expectation,
                   const SystemUnderTest& subject);

}  // namespace elgen
