// Inspection: mechanical sanity of a Model, found by sampling the oracle at exact random points.
//
// Finds what no reading of the text shows: a mass matrix singular everywhere (names the coordinate
// or null vector), a planar spin that is no angle's rate, charts that break where det M vanishes, a
// potential that pushes a mass up, inertias that no body can have, names used nowhere. Also says
// which outputs the built-in scene `full` does without.
#pragma once

#include "elgen/diagnostic.hpp"
#include "elgen/model.hpp"
#include "elgen/scene.hpp"

namespace elgen {

/// Errors, warnings and notes of E501 to E522, E613, E614 and E619; never changes the model.
[[nodiscard]] Diagnostics inspect(const Model& model, const Scene& scene);

}  // namespace elgen
