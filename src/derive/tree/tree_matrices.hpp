// Matrices of bodies in frames, by composite inertias: one column for every angle and offset,
// passed on to the steps below it.
//
// A variable x of the tree (an angle, one component of an offset, a velocity of a rotation) moves
// everything its step carries with the unit twist S. With composites at its step:
//
//     M_kl = S_l . (I_k S_k)                                     l below k
//     C_lk = S_l . (I_k S'_k + B_k S_k),   C_kl = (I_k S_k) . S'_l + (B_k^T S_k) . S_l
//
// S' is the rate of S as seen from the world, twist x S, and B = [A 0; -[P]x 0] the part of the
// momentum's rate that is linear in the twist, with P = m v + w x h and
// A = [Sigma w]x - I [w]x - [h]x [v]x of each body, Sigma = 1/2 tr(I) 1 - I. Then C is that of the
// Christoffel symbols: for a mass point m dp/dq^T d/dt(dp/dq). Echeandia, Wensing, Numerical
// Methods to Compute the Coriolis Matrix and Christoffel Symbols for Rigid-Body Systems (2021).
//
// Variables x(q, t) are mapped to coordinates by J = dx/dq: M = J^T M_x J, and
// C = J^T (C_x J + M_x dJ/dt).
#pragma once

#include <map>

#include "derive/tree/tree.hpp"

namespace elgen {

/// Entries of an n_v x n_v matrix that may differ from zero, by row and column.
using SparseMatrix = std::map<std::pair<std::size_t, std::size_t>, GiNaC::ex>;

/// entries += matrix, of n columns.
void add(const SparseMatrix& matrix, Vector& entries, std::size_t n);

[[nodiscard]] SparseMatrix tree_mass_matrix(Tree& tree);
[[nodiscard]] SparseMatrix tree_coriolis_matrix(Tree& tree);

/// Whether every variable is linear in the coordinates, with constant coefficients.
[[nodiscard]] bool has_linear_variables(Tree& tree);

/// d tau/dq and d tau/dv of the inertial forces and weights; for linear variables. With
/// R1 = v x S, R2 = a x S + v x R1 (v, a of the step below, gravity an acceleration of the base):
///
///     dtau_k/dq_l = (I_k S_k).R2_l + 2 (B_k^T S_k).R1_l         l below k, or k
///     dtau_l/dq_k = S_l.(I_k R2_k + 2 B_k R1_k + S_k x* f_k)
///     dtau_k/dv_l = (I_k S_k).(R1_l + S'_l) + 2 (B_k^T S_k).S_l,   and so on
///
/// For a rotation d/dq is along the rotation vector in its own axes. Singh, Russell, Wensing,
/// Efficient Analytical Derivatives of Rigid-Body Dynamics (2022).
struct TreeDerivatives {
  SparseMatrix by_position = {};
  SparseMatrix by_velocity = {};
};
[[nodiscard]] TreeDerivatives tree_derivatives(Tree& tree, Tangent& second);

}  // namespace elgen
