// Derivatives of the dynamics: slopes of w.(M a + bias - B u) along displacements, and for forward
// dynamics a solve with M. Of each all entries, one field after another, and w.X y of one field.
#pragma once

#include "oracle/mechanics.hpp"

namespace elgen::oracle {

/// B = dQ/du: n x m for n velocities and m inputs, row-major.
[[nodiscard]] std::vector<cln::cl_R> input_entries(Mechanics& at);

/// d tau/dq, d tau/dv: n x n each for n velocities, row-major.
[[nodiscard]] std::vector<cln::cl_R> inverse_derivatives(Mechanics& at);
[[nodiscard]] cln::cl_R inverse_contraction(Mechanics& at, const Contraction& by);

/// da/dq, da/dv, da/du: n x n, n x n and n x inputs, row-major.
[[nodiscard]] std::vector<cln::cl_R> forward_derivatives(Mechanics& at);
[[nodiscard]] cln::cl_R forward_contraction(Mechanics& at, const Contraction& by);

/// A, 2n x 2n, and B, 2n x inputs, of d(dx)/dt = A dx + B du with x = (dq, dv). Of a rotation
/// vector dq the rate is dv - w x dq.
[[nodiscard]] std::vector<cln::cl_R> state_matrices(Mechanics& at);
[[nodiscard]] cln::cl_R state_contraction(Mechanics& at, const Contraction& by);

}  // namespace elgen::oracle
