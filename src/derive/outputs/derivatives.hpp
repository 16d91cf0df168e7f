// Derivatives of the dynamics, at the caller's state.
//
//     inverse    tau = M a + bias:            d tau/dq, d tau/dv
//     forward    M a = B u - bias:            da/dq = -M^-1 d(M a + bias - B u)/dq at that a,
//                                             da/dv = -M^-1 d bias/dv,  da/du = M^-1 B
//     linear     x = (dq, dv):                dx/dt = A x + B du,  A = [0 1; da/dq da/dv],
//                                             B = [0; da/du]
//
// For a rotation dq is the rotation vector in its own axes; its rate is dv - w x dq, so the upper
// left block of A holds -[w]x there.
//
// Bodies in frames go by columns (tree_matrices.hpp) where every angle and offset is linear in the
// coordinates, everything else by a forward pass along each unit direction.
#pragma once

#include "derive/lagrangian/derivation.hpp"

namespace elgen {

/// n_v x n_v each, row-major.
struct InverseDerivatives {
  Vector by_position;
  Vector by_velocity;
};
[[nodiscard]] InverseDerivatives inverse_dynamics_derivatives(Derivation& derivation);

/// n_v x n_v, n_v x n_v, n_v x n_u.
struct ForwardDerivatives {
  Vector by_position;
  Vector by_velocity;
  Vector by_input;
};
[[nodiscard]] ForwardDerivatives forward_dynamics_derivatives(Derivation& derivation);

/// 2 n_v x 2 n_v and 2 n_v x n_u.
struct Linearization {
  Vector a;
  Vector b;
};
[[nodiscard]] Linearization linearization(Derivation& derivation);

}  // namespace elgen
