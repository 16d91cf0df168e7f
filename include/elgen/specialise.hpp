// specialise: Lagrangian -> smaller Lagrangian. Fixed parameters become exact numbers; what they
// make zero disappears from every definition; locked and cyclic coordinates leave; energies and
// forces that a scene expands become polynomials.
#pragma once

#include "elgen/lagrangian.hpp"
#include "elgen/scene.hpp"

namespace elgen {

/// `lagrangian` is that of `checked`. E312, E313, E314: a fixed parameter, a lock or `[routh]`
/// makes something divide by zero, undefined or complex whatever the state is; with the span of its
/// declaration.
[[nodiscard]] Result<Lagrangian> specialise(WholeLagrangian lagrangian,
                                            const CheckedModel& checked);

}  // namespace elgen
