// energy_sum: the total energy as the sum of the two energies of the same program.
//
//     before    total_energy = 1/2 m l^2 v^2 + m g l (1 - cos(theta))
//     after     total_energy = kinetic_energy + potential_energy, each as its function computes it
#pragma once

#include <cstddef>
#include <optional>

#include "elgen/program.hpp"

namespace elgen {

/// The sum of the kinetic and potential energy in `chosen`, which has the emitted forms of all
/// functions before `index`. None if function `index` of `recursive` is not a total energy, if one
/// of the energies is missing, or if V has terms with rates, which potential_energy omits. Values
/// of 64 digits at random points decide the last condition.
[[nodiscard]] std::optional<Function> energy_sum(const Program& recursive, const Program& chosen,
                                                 std::size_t index);

}  // namespace elgen
