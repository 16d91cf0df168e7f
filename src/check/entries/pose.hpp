// Poses: where a frame is in the world, and how it turns, as expressions.
#pragma once

#include "check/names/context.hpp"

namespace elgen {

/// Fills `rotation`, `origin` and `spin` from the steps and the parent.
///
///     before    parent world, translate (l, 0, 0), turn by q about z
///     after     R = [cos(q), -sin(q), 0; sin(q), cos(q), 0; 0, 0, 1], origin (l, 0, 0)
void write_pose(Context& context, Frame& frame);

}  // namespace elgen
