// energy_sum: the total energy as the sum of the energies that the same program has.
//
//     before    total_energy = 1/2 m l^2 v^2 + m g l (1 - cos(theta))
//     after     total_energy = kinetic_energy + potential_energy, each as it is computed there
#pragma once

#include <cstddef>
#include <optional>

#include "elgen/program.hpp"

namespace elgen {

/// None where the function `index` of `recursive` is no total energy, where the program does not
/// have both, or where V has a part in the rates, which potential_energy has not: told by values of
/// 64 digits at random points. `chosen` has the functions before `index` as they are emitted.
[[nodiscard]] std::optional<Function> energy_sum(const Program& recursive, const Program& chosen,
                                                 std::size_t index);

}  // namespace elgen
