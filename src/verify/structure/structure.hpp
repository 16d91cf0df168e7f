// check_structure: identities between the functions of a program, checked in 64-digit arithmetic at
// nominal states.
#pragma once

#include <cstdint>
#include <vector>

#include "elgen/certificate.hpp"
#include "program/evaluate/subject.hpp"

namespace elgen {

/// One row per identity, if the program has its functions:
///
///     N + N^T = 0, N = (sum_k dM/dq_k v_k) - 2 C
///     dE/dt = v.(B u + Q - dD/dv + A^T lambda) - dL/dt
///     M a(q, v, u) + bias = B u + A^T lambda
///     A a + gamma = -2 zeta omega r - omega^2 f
///     dp/dv = M,  dE/dv = M v,  p = 2 dT/dv - d(T + V)/dv,  g = dV0/dq
///     velocity_force, bias and tau from their parts, tau from the regressor
///     H(q, p) = E, dL/dv = p and (dq/dt, dp/dt) = d/dt (q, dL/dv) at v = M^-1 (p - b)
///     Jacobians and biases of [[output]]s from the derivatives of their values
///
/// The terms in A appear with constraints only. Two more rows: M is symmetric, bit by bit, and
/// positive definite, by its pivots.
[[nodiscard]] std::vector<CertificateRow> check_structure(const SystemUnderTest& subject,
                                                          const std::vector<State>& states);

}  // namespace elgen
