// Expected equations of motion: to which row an equation belongs, in which terms a wrong equation
// differs from the right one, and which accelerations the equations determine. Expected numbers: an
// [[expect]] `at` a state, such as a published table, compared with the oracle.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "verify/structure/expectations.hpp"
#include "verify/structure/proofs.hpp"

namespace elgen {

/// Finds a row of M a + bias - B u - A^T lambda such that `equation`, left - right, is a multiple
/// of the row: "row theta of the equations of motion, times 1/(m*l)". "" if no row is proved.
[[nodiscard]] std::string matching_row(const ExpectationProver& proofs, const Fraction& equation);

/// In which terms `equation`, left - right of the entry, differs from the nearest right form, the
/// right form with the fewest differing terms. Right forms: f times a row of M a + bias - B u - A^T
/// lambda, f free of velocities, accelerations, inputs and multipliers; and `equation` minus its
/// value along the motion. "compared with row theta of the equations of motion, times 1/(m*l^2):
/// the term g*sin(theta)/l has the opposite sign". If too many terms differ: "left - right is m*g
/// along the motion". "" if this text is too long, if there are no closed forms, or if the model
/// has constraints and `equation` has no multipliers.
[[nodiscard]] std::string difference_from_motion(const ExpectedEntry& entry,
                                                 const ExpectationProver& proofs,
                                                 const Fraction& equation);

/// Names the term in which `written` differs from a quantity that is constant at u = 0: "compared
/// with a conserved quantity: the term m*g*l*cos(theta) has the opposite sign". "" if no change of
/// one term's factor makes `written` constant, or if it contains momenta.
[[nodiscard]] std::string difference_from_constant(const ExpectationProver& proofs,
                                                   const Fraction& written);

/// The state with the accelerations and multipliers of the motion; none if M is singular, or if the
/// constraints cannot be satisfied.
[[nodiscard]] std::optional<State> motion_at(const Model& model, const State& start);

/// True if equations and constraints are fewer than the accelerations and the multipliers in the
/// equations. Such equations are judged one by one.
[[nodiscard]] bool is_incomplete(const Model& model, const Expectation& equations);

/// The row of an equation that holds for any accelerations and multipliers, at all `states`; none
/// for other equations. The row is `noted`, because an identity proves nothing.
[[nodiscard]] std::optional<CertificateRow> identity_row(const ExpectedEntry& entry,
                                                         const std::vector<State>& states);

/// Adds a row for the rank of d(left - right)/da together with the rows of A, at the motions of
/// some `states`. E540 if the rank is less than the number of velocities, or if another
/// acceleration also satisfies all equations. For an incomplete set, the row counts the independent
/// equations; E540 if there are none. Multipliers in the equations are unknowns, too. `identities`
/// are equations with an identity_row(); they do not count.
void check_rank(ExpectationReport& report, const Expectation& equations,
                const std::vector<ExpressionId>& identities, const SystemUnderTest& subject,
                const std::vector<State>& states);

/// Adds a row for each entry of an expectation `at` a state. E510 for each entry without a value,
/// or with an error larger than the expectation's tolerance times the largest entry of its field.
void check_numbers(ExpectationReport& report, const Expectation& expectation,
                   const SystemUnderTest& subject);

}  // namespace elgen
