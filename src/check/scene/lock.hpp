// Locks: which coordinates a scene holds at which functions of time, and the model without them.
#pragma once

#include "check/names/context.hpp"
#include "elgen/model.hpp"
#include "elgen/syntax.hpp"

namespace elgen {

/// Fills Model::locks, in the order of the coordinates. `scene` may be null. E612, E615, and what
/// the values' expressions give.
void read_locks(Context& context, const FileSyntax* scene);

/// The model in which functions of time stand for the locked coordinates, fewer of which are left.
/// The model given is kept as `unlocked`. Without locks it is returned as it is. Closed forms of
/// [[expect]] are those of the whole model and do not carry over.
[[nodiscard]] Model locked(Model model);

}  // namespace elgen
