// The named things of a model in the order in which they need each other.
#pragma once

#include <vector>

#include "elgen/lagrangian.hpp"

namespace elgen {

/// Definitions, prescribed motions, points of the world, and the frames (and their points) that an
/// energy, force, output, body or step of a frame mentions, each after those its own expressions
/// refer to; otherwise as declared. The model's are acyclic (check).
[[nodiscard]] std::vector<Entity> entities_in_order(const Model& model);

}  // namespace elgen
