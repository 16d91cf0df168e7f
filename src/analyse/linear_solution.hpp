// Linear solution: equations of rest that are linear, as those of masses on springs, in closed
// form.
#pragma once

#include <optional>
#include <vector>

#include "analyse/exact_roots.hpp"

namespace elgen {

/// The general solution of equations that are linear in the unknowns, perhaps times powers of them
/// as those of orbits are (p^2/(m r^3) = m mu/r^2): some of these are any, the
/// others expressions of them. `is_solvable` is false where there is none; the whole is none where
/// the equations are not linear, or a form is beyond the budget, or 0 in 64 digits though it is not
/// the empty sum.
struct LinearSolution {
  bool is_solvable = true;
  std::vector<CoordinateAtRest> values = {};
};
[[nodiscard]] std::optional<LinearSolution> linear_solution(ClosedForms& forms,
                                                            const std::vector<Fraction>& rows,
                                                            const Unknowns& unknowns,
                                                            const Arguments<Real>& at);

}  // namespace elgen
