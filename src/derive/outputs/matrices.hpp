// Outputs that are matrices, row-major.
#pragma once

#include "derive/lagrangian/derivation.hpp"

namespace elgen {

/// M = d2L/dv2, n_v x n_v, symmetric: both halves hold the same expressions. One forward and one
/// reverse pass per column; a point mass gives sum m dp/dq_i . dp/dq_j.
[[nodiscard]] Vector mass_matrix(Derivation& derivation);

/// C_ij = 1/2 d(C v)_i/dv_j, the Christoffel form, for which (sum dM/dq_k v_k) - 2 C is skew.
/// n forward passes over C v.
[[nodiscard]] Vector coriolis_matrix(Derivation& derivation);

/// B = dQ/du, n_v x n_u.
[[nodiscard]] Vector input_matrix(Derivation& derivation);

/// dy/dq of each value, one reverse pass per row.
[[nodiscard]] Vector jacobian(Derivation& derivation, const Terms& values);

/// d2y/dt2 at a = 0.
[[nodiscard]] Vector second_rate(Derivation& derivation, const Terms& values);

/// Of a frame's twist (angular velocity; velocity of its origin): d twist/dv, 6 x n_v, and what is
/// left of its rate at a = 0.
[[nodiscard]] Vector twist_jacobian(Derivation& derivation, const TwistOutput& output);
[[nodiscard]] Vector twist_bias(Derivation& derivation, const TwistOutput& output);

}  // namespace elgen
