// Units of the entries of outputs, from the units of velocities and inputs.
#pragma once

#include <optional>

#include "elgen/scene.hpp"

namespace elgen::checking {

/// Unit of entry (row, column), counted from 0; nothing where a unit is not declared or not known.
///
///     mass: J s^2/(q_i q_j)   coriolis: J s/(q_i q_j)   momentum: J s/q_i   force: J/q_i
///     input: J/(q_i u_j)      acceleration: q_i/s^2     energy: J
[[nodiscard]] std::optional<Unit> unit_of_entry(const Model& model, const OutputRequest& output,
                                                std::uint32_t row, std::uint32_t column);

}  // namespace elgen::checking
