// Momenta p = M v + b, b = dL/dv at rest: the velocities that they give, and their rates.
#pragma once

#include <vector>

#include "elgen/oracle.hpp"
#include "oracle/mechanics.hpp"

namespace elgen::oracle {

/// x_i = e_i.x of each unit direction.
[[nodiscard]] std::vector<cln::cl_R> unit_products(
    Mechanics& at, cln::cl_R (Mechanics::*product)(const Direction&));

/// M^-1 (p - b) at the position and time of a state. OutsideDomain where M is singular. Cost: the
/// mass matrix and one solve.
[[nodiscard]] std::vector<cln::cl_R> velocities_of_momenta(const Model& model, State state,
                                                           const std::vector<cln::cl_R>& p);

/// dL/dq + B u + Q - dD/dv at a state, and for angular velocities - [w]x dL/dw.
[[nodiscard]] std::vector<cln::cl_R> momentum_rates(const Model& model, const State& state);

}  // namespace elgen::oracle
