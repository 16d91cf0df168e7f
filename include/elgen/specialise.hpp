// specialise: Lagrangian -> smaller Lagrangian. Fixed parameters become exact numbers, and terms
// that become zero disappear from every definition. Locked and cyclic coordinates are eliminated.
// Energies and forces become polynomials if the scene expands them.
#pragma once

#include "elgen/lagrangian.hpp"
#include "elgen/scene.hpp"

namespace elgen {

/// `lagrangian` with the scene of `checked` applied. `lagrangian` must be formulated from the model
/// of `checked`. A fixed parameter, a lock or `[routh]` may make a denominator 0 (E312), a value
/// undefined (E313) or a value complex (E314) at every state. The error has the span of the
/// parameter, of the lock or of the first entry of `[routh]`.
[[nodiscard]] Result<Lagrangian> specialise(UnreducedLagrangian lagrangian,
                                            const CheckedModel& checked);

}  // namespace elgen
