// Chart breaks: points of rest with a singular M, where equations of motion fail.
#pragma once

#include <vector>

#include "analyse/rest.hpp"
#include "elgen/analyse.hpp"
#include "elgen/evaluate.hpp"

namespace elgen {

/// The numbers of values, 0 for undefined ones.
[[nodiscard]] std::vector<cln::cl_R> numbers_of(const std::vector<Real>& values);

/// M at a state of rest, row-major.
[[nodiscard]] std::vector<cln::cl_R> mass_at(const RestProgram& rest, const State& state);

/// Whether M is singular at a point. Adds the coordinates that cause it to `breaks`, once each:
/// those whose shift alone makes M regular, else all in the equations at rest.
[[nodiscard]] bool breaks_chart(const RestProgram& rest, const RestPoint& point,
                                std::vector<ChartBreak>& breaks);

}  // namespace elgen
