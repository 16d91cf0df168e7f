// Newton refinement: a solution to 64 digits.
#pragma once

#include <optional>
#include <vector>

#include "elgen/evaluate.hpp"
#include "elgen/model.hpp"

namespace elgen {

/// d f/d q of the entries of a function, row-major: f moves with the velocities `along`, one column
/// for each. Of rotations a column is along a turn about an axis of the body.
[[nodiscard]] std::vector<Real> position_slopes(const Model& model, const Program& program,
                                                const Function& function, const Arguments<Real>& at,
                                                const std::vector<std::uint32_t>& along);

/// d f/d v of the entries of a function, row-major, one column for each velocity.
[[nodiscard]] std::vector<Real> velocity_slopes(const Program& program, OutputKind kind,
                                                const Arguments<Real>& at);

/// The solution f = 0 near the arguments, where only the coordinates of these velocities move; as
/// many entries as velocities, else none. None also where it is not reached in 200 steps.
[[nodiscard]] std::optional<Arguments<Real>> refined(const Model& model, const Program& program,
                                                     const Function& function,
                                                     Arguments<Real> start,
                                                     const std::vector<std::uint32_t>& along);

}  // namespace elgen
