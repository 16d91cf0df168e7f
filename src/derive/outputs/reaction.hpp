// The generalized forces that hold locked coordinates.
#pragma once

#include "derive/lagrangian/derivation.hpp"

namespace elgen {

/// (d/dt dL/dv - dL/dq + dD/dv - Q - B u) of the locked coordinates that want it, L before locking,
/// at q = s(t), v = ds/dt, a = d2s/dt2: what must act beside the inputs. J per unit of the
/// coordinate.
[[nodiscard]] Vector reaction(Derivation& derivation);

}  // namespace elgen
