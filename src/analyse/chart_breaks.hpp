// Chart breaks: places of rest at which M is singular, and no equation of motion says more.
#pragma once

#include <vector>

#include "analyse/rest.hpp"
#include "elgen/analyse.hpp"
#include "elgen/evaluate.hpp"

namespace elgen {

/// 0 where there is no number.
[[nodiscard]] std::vector<cln::cl_R> numbers_of(const std::vector<Real>& values);

/// M at a state of rest, row by row.
[[nodiscard]] std::vector<cln::cl_R> mass_at(const RestProgram& rest, const State& state);

/// Whether M is singular at a point; the coordinates to blame are added to `breaks`, each place
/// once: those whose move alone makes M regular, else all that the equations at rest hold.
[[nodiscard]] bool breaks_chart(const RestProgram& rest, const RestPoint& point,
                                std::vector<ChartBreak>& breaks);

}  // namespace elgen
