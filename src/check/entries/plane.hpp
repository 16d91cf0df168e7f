// Planar models: what frames must not do there.
#pragma once

#include "check/names/context.hpp"

namespace elgen {

/// E516 for every step of a frame that leaves the plane of a model whose vectors have 2 components:
/// a turn about an axis other than z, or a shift along z.
void check_plane(Context& context);

}  // namespace elgen
