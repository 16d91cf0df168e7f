// Regressor: the inverse dynamics at any values of the inertial parameters. The parameters of
// bodies, points and armatures are factors of terms of T and V, written as expressions:
//
//     m       T = 1/2 |do/dt|^2         V = -g.o      o: the frame's origin, or the point
//     m c_i   T = do/dt . de_i/dt       V = -g.e_i    e_i: axis i of the frame
//     I_ij    T = w_i w_j, 1/2 w_i^2                  w: the spin in the axes of the frame
//
// Y and rest are differences of the resulting forces, which are affine in the parameters.
#pragma once

#include <vector>

#include "oracle/mechanics.hpp"

namespace elgen::oracle {

/// d.tau = d.(Y pi + rest) for each direction d, at the inertial parameters pi of each choice. If
/// `uses_reference`, C(q, v) r, drift and friction use the reference velocity r of the state. The
/// choices share the values of everything that does not depend on pi.
[[nodiscard]] std::vector<std::vector<cln::cl_R>> forces_of_parameters(
    const Model& model, const State& state, const std::vector<std::vector<cln::cl_R>>& choices,
    const std::vector<Direction>& directions, bool uses_reference);

/// pi at the parameters of the state. For a body in a frame the moments of inertia are about the
/// frame's origin: I + m (c.c 1 - c c^T).
[[nodiscard]] std::vector<cln::cl_R> regressor_parameters(const Model& model, const State& state);

}  // namespace elgen::oracle
