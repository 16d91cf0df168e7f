// Energies and forces as polynomials in small deviations.
#pragma once

#include "elgen/lagrangian.hpp"

namespace elgen {

/// Replaces masses, energies and forces by their expansions, as `lagrangian.expansion` says. User
/// outputs stay exact.
[[nodiscard]] Lagrangian expanded(Lagrangian lagrangian);

}  // namespace elgen
