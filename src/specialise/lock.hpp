// lock: what a scene holds at functions of time leaves the coordinates.
#pragma once

#include "elgen/lagrangian.hpp"

namespace elgen {

/// q_i = s(t), v_i = ds/dt in every energy, force and frame; the row and the column of q_i are
/// gone. Where a reaction is wanted, the Lagrangian before is kept in `holding`.
void lock(Lagrangian& lagrangian);

}  // namespace elgen
