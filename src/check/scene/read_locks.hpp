// Locks of a scene: which coordinates it holds, and at which functions of time.
#pragma once

#include "check/names/context.hpp"
#include "elgen/syntax.hpp"

namespace elgen {

/// Fills Model::locks, in the order of the coordinates. `scene` may be null. E612, E615, and what
/// the values' expressions give.
void read_locks(Context& context, const FileSyntax* scene);

}  // namespace elgen
