// energy_sum: the total energy as the sum of the energies of the same program.
//
//     before    total_energy = 1/2 m l^2 v^2 + m g l (1 - cos(theta))
//     after     total_energy = kinetic_energy + potential_energy, each as it is computed there
#pragma once

#include <cstddef>
#include <optional>

#include "elgen/program.hpp"

namespace elgen {

/// None if function `index` of `recursive` is no total energy, the program lacks one of the
/// energies, or V has terms with rates, which potential_energy omits. The last is checked by values
/// of 64 digits at random points. `chosen` has the functions before `index` as emitted.
[[nodiscard]] std::optional<Function> energy_sum(const Program& recursive, const Program& chosen,
                                                 std::size_t index);

}  // namespace elgen
