// Chart breaks: solutions of the equations at rest at which M is singular, so that the equations of
// motion fail there.
#pragma once

#include <vector>

#include "analyse/rest.hpp"
#include "elgen/analyse.hpp"
#include "elgen/evaluate.hpp"

namespace elgen {

/// The values as real numbers; undefined values become 0.
[[nodiscard]] std::vector<cln::cl_R> values_or_zero(const std::vector<Real>& values);

/// M at a state of rest, row-major.
[[nodiscard]] std::vector<cln::cl_R> mass_matrix_at(const RestProgram& rest, const State& state);

/// True if M is singular at a point. Adds the coordinates that cause the break to `breaks`, each
/// once: every coordinate whose shift makes M regular. If no single shift does, adds every
/// coordinate in the equations at rest.
[[nodiscard]] bool find_chart_breaks(const RestProgram& rest, const RestPoint& point,
                                     std::vector<ChartSingularity>& breaks);

}  // namespace elgen
