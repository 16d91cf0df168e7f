// Structure: identities between the functions of a program, checked in 64-digit arithmetic at
// nominal states.
#pragma once

#include <cstdint>
#include <vector>

#include "elgen/certificate.hpp"
#include "program/evaluate/subject.hpp"

namespace elgen {

/// One row per identity whose functions the program has:
///
///     (sum_k dM/dq_k v_k) - 2 C skew         dE/dt = v.(B u + Q - dD/dv) - dL/dt
///     M a(q, v, u) + bias = B u              dp/dv = M,  dE/dv = M v,  p = 2 dT/dv - d(T + V)/dv
///     both with B u + A^T lambda, and A a + gamma = -2 zeta omega r - omega^2 f, under constraints
///     g = dV0/dq                             C v, bias and tau from their parts
///     H(q, p) = E, dL/dv = p and (dq/dt, dp/dt) = d/dt (q, dL/dv) at v = M^-1 (p - b)
///     Jacobians and biases of [[output]]s from the derivatives of their values
///
/// Two more rows: M is symmetric (in every bit), and positive definite (by its pivots).
[[nodiscard]] std::vector<CertificateRow> check_structure(const Subject& subject,
                                                          const std::vector<State>& states);

}  // namespace elgen
