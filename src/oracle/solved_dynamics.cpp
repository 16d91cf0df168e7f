// Computes the entries of the mass matrix, then solves one linear system: row i of L from the rows
// above it, then forward, diagonal and backward substitution. Velocities follow from momenta by one
// solve with the same M. Rates of momenta are the terms of Lagrange's equation other than d/dt
// dL/dv.
#include "oracle/solved_dynamics.hpp"

#include <algorithm>

#include "model/elimination.hpp"
#include "oracle/mechanics.hpp"
#include "oracle/real_functions.hpp"

namespace elgen::oracle {

namespace {

using cln::cl_R;

/// A pivot D_i counts as zero if |D_i / M_ii| is below this.
const cl_R& min_relative_pivot() {
  static const cl_R share = cln::expt(cl_R(10), -75);
  return share;
}

cl_R checked_relative_pivot(const cl_R& pivot, const cl_R& diagonal) {
  const cl_R share = quotient(pivot, diagonal);
  if (cln::abs(share) < min_relative_pivot()) throw OutsideDomain("singular matrix");
  return share;
}

/// Replaces the lower triangle of `m` by L and the diagonal by D; returns the pivots D_i / M_ii.
std::vector<cl_R> factorise(std::vector<cl_R>& m, std::size_t n) {
  std::vector<cl_R> shares;
  for (std::size_t i = 0; i < n; ++i) {
    const cl_R diagonal = m[i * n + i];
    for (std::size_t j = 0; j < i; ++j) {
      for (std::size_t k = 0; k < j; ++k) {
        m[i * n + j] = m[i * n + j] - m[i * n + k] * m[k * n + k] * m[j * n + k];
      }
      m[i * n + j] = m[i * n + j] / m[j * n + j];
      m[i * n + i] = m[i * n + i] - m[i * n + j] * m[i * n + j] * m[j * n + j];
    }
    shares.push_back(checked_relative_pivot(m[i * n + i], diagonal));
  }
  return shares;
}

}  // namespace

SymmetricSolution solve_symmetric(std::vector<cl_R> matrix, const std::vector<cl_R>& right_side) {
  const std::size_t n = right_side.size();
  SymmetricSolution solution{right_side, factorise(matrix, n)};
  std::vector<cl_R>& x = solution.x;
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = 0; j < i; ++j) x[i] = x[i] - matrix[i * n + j] * x[j];
  }
  for (std::size_t i = n; i-- > 0;) {
    x[i] = x[i] / matrix[i * n + i];
    for (std::size_t j = i + 1; j < n; ++j) x[i] = x[i] - matrix[j * n + i] * x[j];
  }
  return solution;
}

SymmetricSolution solve_mass(const Model& model, std::vector<cl_R> mass,
                             const std::vector<cl_R>& right_side) {
  if (!eliminates_backward(model)) return solve_symmetric(std::move(mass), right_side);
  std::reverse(mass.begin(), mass.end());
  SymmetricSolution solution =
      solve_symmetric(std::move(mass), {right_side.rbegin(), right_side.rend()});
  std::reverse(solution.x.begin(), solution.x.end());
  std::reverse(solution.relative_pivots.begin(), solution.relative_pivots.end());
  return solution;
}

std::vector<cl_R> negate(std::vector<cl_R> values) {
  for (cl_R& value : values) value = -value;
  return values;
}

std::vector<cl_R> net_forces(Mechanics& at) {
  std::vector<cl_R> forces;
  for (std::size_t i = 0; i < at.size(); ++i) {
    const Direction w = at.unit(i);
    forces.push_back(at.input_force(w, at.state().u) - bias(at, w));
  }
  return forces;
}

std::vector<cl_R> unit_products(Mechanics& at, cl_R (Mechanics::*product)(const Direction&)) {
  std::vector<cl_R> values;
  for (std::size_t i = 0; i < at.size(); ++i) values.push_back((at.*product)(at.unit(i)));
  return values;
}

std::vector<cl_R> velocities_of_momenta(const Model& model, State state,
                                        const std::vector<cl_R>& p) {
  state.v.assign(p.size(), 0);
  Mechanics at(model, state);
  std::vector<cl_R> right_side = unit_products(at, &Mechanics::momentum);
  for (std::size_t i = 0; i < p.size(); ++i) right_side[i] = p[i] - right_side[i];
  return solve_mass(model, at.mass_matrix(), right_side).x;
}

std::vector<cl_R> momentum_rates(const Model& model, const State& state) {
  Mechanics at(model, state);
  const std::vector<cl_R> turning = at.cross_velocity(unit_products(at, &Mechanics::momentum));
  std::vector<cl_R> values;
  for (std::size_t i = 0; i < at.size(); ++i) {
    const Direction w = at.unit(i);
    values.push_back(at.position_gradient(w) - turning[i] + at.input_force(w, state.u) +
                     at.applied_force(w) - at.dissipation_force(w));
  }
  return values;
}

/// B_ij = e_i.B e_j
std::vector<cl_R> input_matrix_entries(Mechanics& at) {
  const std::size_t inputs = at.state().u.size();
  std::vector<cl_R> values;
  for (std::size_t k = 0; k < at.size() * inputs; ++k) {
    values.push_back(at.input_force(at.unit(k / inputs), unit_direction(inputs, k % inputs)));
  }
  return values;
}

}  // namespace elgen::oracle
