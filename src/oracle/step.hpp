// One step of a method, by its definition, from accelerations, or rates, that are solved for at
// each of its states.
#pragma once

#include <vector>

#include "elgen/oracle.hpp"

namespace elgen::oracle {

/// q, then v, at t + h, with u held, then the residual of an implicit method; quaternions are of
/// length 1. Throws OutsideDomain. Cost: four linear solves of rk4, two of verlet, one for each
/// iteration of midpoint and one more.
[[nodiscard]] std::vector<cln::cl_R> step(const Model& model, const OutputRequest& output,
                                          const State& state);

}  // namespace elgen::oracle
