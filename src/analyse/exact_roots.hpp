// Exact roots: closed forms of what was found in 64 digits, each put into the equations and kept
// only where these become the empty sum.
//
//     0, pi, +-pi/2      in any number of coordinates
//     +-acos(c), asin(c), pi - asin(c)     of one angle, where the equation is a multiple of
//                                          cos(q) - c or sin(q) - c after the above are divided out
//     -b/a                                 of one coordinate, where the equation is a q + b
//
// Equations that are linear in all unknowns, as those of masses on springs, are solved at once.
#pragma once

#include <optional>
#include <vector>

#include "analyse/formulas.hpp"
#include "elgen/analyse.hpp"
#include "elgen/evaluate.hpp"

namespace elgen {

/// Unknown coordinates of some equations, with the kind of search of each.
struct Unknowns {
  std::vector<std::uint32_t> coordinates = {};
  std::vector<SearchKind> kinds = {};
};

/// The closed forms of a root, one for each unknown; none where it has none of these.
[[nodiscard]] std::optional<std::vector<CoordinateAtRest>> exact_root(
    ClosedForms& forms, const std::vector<Fraction>& rows, const Unknowns& unknowns,
    const Arguments<Real>& root);

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

/// The values that replace the unknowns; unknowns that may be anything stay.
[[nodiscard]] Replacements replacements_of(const std::vector<std::uint32_t>& coordinates,
                                           const std::vector<CoordinateAtRest>& values);

/// Whether a form holds the coordinate, or any.
[[nodiscard]] bool holds_coordinate(const Algebra& algebra, const Fraction& form,
                                    std::optional<std::uint32_t> coordinate = {});

}  // namespace elgen
