// Outputs that are generalized forces, and the momentum: vectors of n_v, each J per unit of the
// coordinate (momentum: J s per unit).
#pragma once

#include "derive/lagrangian/derivation.hpp"

namespace elgen {

enum class InputForces : unsigned char { absent, acting };
enum class Bodies : unsigned char { all, without_frames };

/// tau = M a + bias.
[[nodiscard]] Vector inverse_dynamics(Derivation& derivation);

/// The same less B u where the inputs act; without what the bodies in frames add, where asked so.
[[nodiscard]] Vector residual(Derivation& derivation, InputForces inputs, Bodies bodies);

/// C v + drift + g + dD/dv - Q; with the inputs acting, - Q - B u.
[[nodiscard]] Vector bias(Derivation& derivation, InputForces inputs = InputForces::absent);

/// C v: the part quadratic in v. L quadratic in v.
[[nodiscard]] Vector velocity_force(Derivation& derivation, Bodies bodies = Bodies::all);

/// dT/dv of the bodies in frames.
[[nodiscard]] Vector momentum_of_frames(Derivation& derivation);

/// (dM/dt) v + (db/dq - (db/dq)^T) v + db/dt - dT0/dq with b = b_T - V1. L quadratic in v.
[[nodiscard]] Vector drift(Derivation& derivation);

/// g = dV0/dq. L quadratic in v.
[[nodiscard]] Vector gravity(Derivation& derivation);

/// dD/dv.
[[nodiscard]] Vector dissipation(Derivation& derivation);

/// Q: the declared forces with u = 0; with the inputs acting, Q + B u.
[[nodiscard]] Vector applied_force(Derivation& derivation,
                                   InputForces inputs = InputForces::absent);

/// dL/dv = M v + b.
[[nodiscard]] Vector momentum(Derivation& derivation);

/// dL/dq; along the rotation vector, N^T dL/dq, where rotations turn.
[[nodiscard]] Vector position_gradient(Derivation& derivation);

}  // namespace elgen
