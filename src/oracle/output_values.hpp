// Output values: every row of the output table, from directional derivatives along unit vectors.
#pragma once

#include <vector>

#include "elgen/oracle.hpp"
#include "oracle/mechanics.hpp"

namespace elgen::oracle {

/// All entries, row-major, one field after another. `dynamics` has no entries of its own. Throws
/// OutsideDomain.
[[nodiscard]] std::vector<cln::cl_R> output_values(const Model& model, const OutputRequest& output,
                                                   const State& state);

/// w.x or w.X y; by directional derivatives where the output is made of them, else from all entries
/// (of a structure: of its first field, or as many as w has). Throws OutsideDomain.
[[nodiscard]] cln::cl_R contracted_values(const Model& model, const OutputRequest& output,
                                          const State& state, const Contraction& by);

/// One step of a method, by its definition, from accelerations, or rates, that are solved for at
/// each of its states: q, then v, at t + h, with u held, then the residual of an implicit method;
/// quaternions are of length 1. Throws OutsideDomain. Cost: four linear solves of rk4, two of
/// verlet, one for each iteration of midpoint and one more.
[[nodiscard]] std::vector<cln::cl_R> step(const Model& model, const OutputRequest& output,
                                          const State& state);

}  // namespace elgen::oracle
