// Output values: every row of the output table, from directional derivatives along unit vectors.
#pragma once

#include <vector>

#include "elgen/oracle.hpp"
#include "oracle/constraints.hpp"
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

/// A, then B, of dx(t + h) = A dx + B du, x = (dq, v), rotation vectors on both sides: differences
/// of `step`, right to 80 digits. Cost: three steps for each column.
[[nodiscard]] std::vector<cln::cl_R> step_derivatives(const Model& model,
                                                      const OutputRequest& output,
                                                      const State& state);
[[nodiscard]] cln::cl_R step_contraction(const Model& model, const OutputRequest& output,
                                         const State& state, const Contraction& by);

// Derivatives of the dynamics: slopes of w.(M a + bias - B u) along displacements, and for forward
// dynamics a solve with M. Of each all entries, one field after another, and w.X y of one field.

/// Changes of the accelerations and multipliers of the motion along changes of state and inputs.
[[nodiscard]] ConstrainedMotion motion_slope(Mechanics& at, const Displacement& along,
                                             const Direction& inputs);

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
