// Exact roots: closed forms of roots that are known to 64 digits. A form is accepted only if it
// reduces the equations to the empty sum.
//
//     0, pi, +-pi/2      in any number of coordinates
//     +-acos(c), asin(c), pi - asin(c)     of one angle, if the equation divided by the factors of
//                                          the roots above is a multiple of cos(q) - c or
//                                          sin(q) - c
//     -b/a                                 of one coordinate, if the equation is a q + b
//
// Equations that are linear in all unknowns, such as equations of masses on springs, are solved
// together by elimination.
#pragma once

#include <optional>
#include <vector>

#include "analyse/formulas.hpp"
#include "elgen/analyse.hpp"
#include "elgen/evaluate.hpp"

namespace elgen {

/// The unknown coordinates of some equations, and the kind of search for each.
struct Unknowns {
  std::vector<std::uint32_t> coordinates = {};
  std::vector<SearchKind> kinds = {};
};

/// The closed forms of a root, one per unknown; none if the root has none of the forms above.
[[nodiscard]] std::optional<std::vector<RestCoordinate>> exact_root(
    ClosedForms& forms, const std::vector<Fraction>& rows, const Unknowns& unknowns,
    const Arguments<Real>& root);

/// The general solution of equations that are linear in the unknowns, after powers of unknowns are
/// cleared from denominators, as for orbits (p^2/(m r^3) = m mu/r^2). Some unknowns are arbitrary,
/// the others are expressions of the arbitrary unknowns.
struct LinearSolution {
  bool is_solvable = true;  ///< false if no solution exists
  std::vector<RestCoordinate> values = {};
};
/// None if the equations are not linear, if a form exceeds the budget, or if it is undecided
/// whether a form is 0: its value is 0 in 64 digits, but it is not the empty sum.
[[nodiscard]] std::optional<LinearSolution> linear_solution(ClosedForms& forms,
                                                            const std::vector<Fraction>& rows,
                                                            const Unknowns& unknowns,
                                                            const Arguments<Real>& at);

/// Replacements of the unknowns by their closed forms. Unknowns without a form are kept.
[[nodiscard]] Replacements coordinate_replacements(const std::vector<std::uint32_t>& coordinates,
                                                   const std::vector<RestCoordinate>& values);

/// True if `form` contains `coordinate` or, without `coordinate`, any coordinate.
[[nodiscard]] bool contains_coordinate(const Algebra& algebra, const Fraction& form,
                                       std::optional<std::uint32_t> coordinate = {});

}  // namespace elgen
