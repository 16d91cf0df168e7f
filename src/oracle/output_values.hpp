// Output values: every row of the output table, from directional derivatives along unit vectors.
#pragma once

#include <vector>

#include "elgen/oracle.hpp"
#include "oracle/constraints.hpp"
#include "oracle/mechanics.hpp"

namespace elgen::oracle {

/// All entries, one field after another, row-major. A summary such as `dynamics` has no entries.
/// Throws OutsideDomain.
[[nodiscard]] std::vector<cln::cl_R> output_values(const Model& model, const OutputRequest& output,
                                                   const State& state);

/// w.x of a column or w.X y of a matrix. Computed by directional derivatives if the output supports
/// them, otherwise from the first size(w) * size(y) entries. Throws OutsideDomain.
[[nodiscard]] cln::cl_R contract_output(const Model& model, const OutputRequest& output,
                                        const State& state, const Contraction& by);

/// True if no directional derivatives give the contractions of the output.
[[nodiscard]] bool needs_entries(const OutputRequest& output);

/// One step of a method by its definition: q and v at t + h, then the residual of an implicit
/// method. u is constant; quaternions have length 1. Throws OutsideDomain. Cost in linear solves:
/// rk4 four; verlet two per substep; midpoint one per iteration and one more.
[[nodiscard]] std::vector<cln::cl_R> take_step(const Model& model, const OutputRequest& output,
                                               const State& state);

/// A, then B, of dx(t + h) = A dx + B du, dx = (dq, dv) with rotation vectors in dq. Computed by
/// differences of take_step(), correct to 80 digits. Cost: at least four steps per column.
[[nodiscard]] std::vector<cln::cl_R> step_derivatives(const Model& model,
                                                      const OutputRequest& output,
                                                      const State& state);
[[nodiscard]] cln::cl_R step_contraction(const Model& model, const OutputRequest& output,
                                         const State& state, const Contraction& by);

// Derivatives of the dynamics, from derivatives of w.(M a + bias - B u) along displacements;
// forward dynamics also needs a solve with M. Each output has a function for all its entries, field
// by field, and a function for the contraction w.X y of one field.

/// Derivatives of accelerations and multipliers along a change `along` of (q, v) and `inputs` of u.
[[nodiscard]] ConstrainedMotion motion_slope(Mechanics& at, const Displacement& along,
                                             const Direction& inputs);

/// d tau/dq, d tau/dv: n x n each for n velocities, row-major.
[[nodiscard]] std::vector<cln::cl_R> inverse_derivatives(Mechanics& at);
[[nodiscard]] cln::cl_R inverse_contraction(Mechanics& at, const Contraction& by);

/// da/dq, da/dv, da/du: n x n, n x n and n x inputs, row-major.
[[nodiscard]] std::vector<cln::cl_R> forward_derivatives(Mechanics& at);
[[nodiscard]] cln::cl_R forward_contraction(Mechanics& at, const Contraction& by);

/// A, 2n x 2n, and B, 2n x inputs, of d(dx)/dt = A dx + B du with dx = (dq, dv). A rotation vector
/// dq has the rate dv - v x dq.
[[nodiscard]] std::vector<cln::cl_R> state_matrices(Mechanics& at);
[[nodiscard]] cln::cl_R state_contraction(Mechanics& at, const Contraction& by);

}  // namespace elgen::oracle
