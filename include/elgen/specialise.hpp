// specialise: Lagrangian -> smaller Lagrangian. Fixed parameters become exact numbers, and terms
// that become zero disappear from every definition. Locked and cyclic coordinates are eliminated.
// Energies and forces become polynomials if the scene expands them.
#pragma once

#include "elgen/lagrangian.hpp"
#include "elgen/scene.hpp"

namespace elgen {

/// `lagrangian` with the scene of `checked` applied. `lagrangian` must be formulated from the model
/// of `checked`. E312, E313, E314: because of a fixed parameter, a lock or `[routh]`, an expression
/// is divided by zero, undefined or complex at every state. The error has the span of the
/// declaration.
[[nodiscard]] Result<Lagrangian> specialise(UnreducedLagrangian lagrangian,
                                            const CheckedModel& checked);

}  // namespace elgen
