// Forward dynamics: a = M^-1 (B u - bias).
#pragma once

#include "derive/lagrangian/symmetric_solve.hpp"

namespace elgen {

struct ForwardDynamics {
  Vector acceleration;
  Vector relative_pivots;
  Vector diagonal;  ///< of M: pivots mean nothing where it is 0
};

[[nodiscard]] ForwardDynamics forward_dynamics(Derivation& derivation);

/// The same with a factorisation of M at hand.
[[nodiscard]] Vector acceleration(Derivation& derivation, SymmetricSolve& mass);

}  // namespace elgen
