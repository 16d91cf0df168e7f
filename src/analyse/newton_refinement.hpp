// Newton refinement: solutions of equations f(q) = 0 in 64 digits.
#pragma once

#include <optional>
#include <vector>

#include "elgen/evaluate.hpp"
#include "elgen/model.hpp"

namespace elgen {

/// df/dq of the entries of a function, row-major, with one column for each of `velocities`. The
/// column of an angular velocity is the slope along a turn about a body axis.
[[nodiscard]] std::vector<Real> position_slopes(const Model& model, const Program& program,
                                                const Function& function, const Arguments<Real>& at,
                                                const std::vector<std::uint32_t>& velocities);

/// df/dv of the entries of a function, row-major, one column per velocity.
[[nodiscard]] std::vector<Real> velocity_slopes(const Program& program, OutputKind kind,
                                                const Arguments<Real>& at);

/// The solution of f = 0 near `start`; only the coordinates of the velocities `along` change. None
/// if the numbers of entries and velocities differ, if df/dq is singular, or after 200 steps.
[[nodiscard]] std::optional<Arguments<Real>> newton_solution(
    const Model& model, const Program& program, const Function& function, Arguments<Real> start,
    const std::vector<std::uint32_t>& along);

}  // namespace elgen
