// specialise: Lagrangian -> smaller Lagrangian. Fixed parameters become exact numbers; what they
// make zero disappears from every definition; energies and forces that a scene expands become
// polynomials.
#pragma once

#include "elgen/lagrangian.hpp"
#include "elgen/scene.hpp"

namespace elgen {

[[nodiscard]] Lagrangian specialise(Lagrangian lagrangian, const Specialisation& specialisation);

}  // namespace elgen
