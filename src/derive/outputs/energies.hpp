// Outputs that are energies, in J.
#pragma once

#include "derive/lagrangian/derivation.hpp"

namespace elgen {

/// T. L quadratic in v.
[[nodiscard]] GiNaC::ex kinetic_energy(Derivation& derivation);

/// V0, the potential energy at zero rates. L quadratic in v.
[[nodiscard]] GiNaC::ex potential_energy(Derivation& derivation);

/// V as given, with its part linear in v.
[[nodiscard]] GiNaC::ex full_potential_energy(Derivation& derivation);

/// T + V = T + V0 + V1.v. L quadratic in v.
[[nodiscard]] GiNaC::ex total_energy(Derivation& derivation);

/// E = sum v dL/dv - L; T2 - T0 + V0 where L is quadratic in v.
[[nodiscard]] GiNaC::ex energy_function(Derivation& derivation);

}  // namespace elgen
