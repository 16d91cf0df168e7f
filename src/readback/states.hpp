// states: where equations are compared: parameters at their values, everything else somewhere
// inside its range.
#pragma once

#include <vector>

#include "elgen/evaluate.hpp"
#include "elgen/model.hpp"
#include "elgen/program.hpp"

namespace elgen::reading {

/// Rotations are unit quaternions.
[[nodiscard]] std::vector<Arguments<Real>> comparison_states(const Model& model,
                                                             const LeafNames& leaves,
                                                             std::size_t count);

}  // namespace elgen::reading
