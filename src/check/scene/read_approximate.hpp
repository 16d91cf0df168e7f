// [approximate]: the point a scene expands about.
#pragma once

#include <string>

#include "check/names/context.hpp"
#include "elgen/syntax.hpp"

namespace elgen {

/// Fills Model::approximation; `scene` may be null. E105, E614.
void read_approximation(Context& context, const SceneSyntax* scene);

/// "order 3 about theta = 0, u = 0 with theta small", for the canonical text of a scene.
[[nodiscard]] std::string canonical_text(const Model& model, const Approximation& approximation);

}  // namespace elgen
