// Exact roots: closed forms of roots known to 64 digits, accepted only if the equations reduce to
// the empty sum with them.
//
//     0, pi, +-pi/2      in any number of coordinates
//     +-acos(c), asin(c), pi - asin(c)     of one angle, if the equation without the above roots
//                                          is a multiple of cos(q) - c or sin(q) - c
//     -b/a                                 of one coordinate, if the equation is a q + b
//
// Equations that are linear in all unknowns, as those of masses on springs, are solved at once.
#pragma once

#include <optional>
#include <vector>

#include "analyse/formulas.hpp"
#include "elgen/analyse.hpp"
#include "elgen/evaluate.hpp"

namespace elgen {

/// Unknown coordinates of some equations, with their kinds of search.
struct Unknowns {
  std::vector<std::uint32_t> coordinates = {};
  std::vector<SearchKind> kinds = {};
};

/// The closed forms of a root, one per unknown; none if it has none of these.
[[nodiscard]] std::optional<std::vector<CoordinateAtRest>> exact_root(
    ClosedForms& forms, const std::vector<Fraction>& rows, const Unknowns& unknowns,
    const Arguments<Real>& root);

/// The general solution of equations linear in the unknowns, up to factors of their powers as for
/// orbits (p^2/(m r^3) = m mu/r^2). Some unknowns are arbitrary, the others are expressions of
/// them. `is_solvable` is false if there is no solution. None if the equations are not linear, or
/// if a form exceeds the budget or is 0 in 64 digits without being the empty sum.
struct LinearSolution {
  bool is_solvable = true;
  std::vector<CoordinateAtRest> values = {};
};
[[nodiscard]] std::optional<LinearSolution> linear_solution(ClosedForms& forms,
                                                            const std::vector<Fraction>& rows,
                                                            const Unknowns& unknowns,
                                                            const Arguments<Real>& at);

/// The values that replace the unknowns. Arbitrary unknowns stay.
[[nodiscard]] Replacements replacements_of(const std::vector<std::uint32_t>& coordinates,
                                           const std::vector<CoordinateAtRest>& values);

/// Whether a form contains the coordinate, or any.
[[nodiscard]] bool holds_coordinate(const Algebra& algebra, const Fraction& form,
                                    std::optional<std::uint32_t> coordinate = {});

}  // namespace elgen
