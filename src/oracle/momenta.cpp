// momenta: one solve with the oracle's own M; rates are what is left of Lagrange's equation.
#include "oracle/momenta.hpp"

#include "oracle/solved_dynamics.hpp"

namespace elgen::oracle {

using cln::cl_R;

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
  return solve_mass(model, mass_matrix_values(at), right_side).x;
}

std::vector<cl_R> momentum_rates(const Model& model, const State& state) {
  Mechanics at(model, state);
  const std::vector<cl_R> turning = at.across_velocity(unit_products(at, &Mechanics::momentum));
  std::vector<cl_R> values;
  for (std::size_t i = 0; i < at.size(); ++i) {
    const Direction w = at.unit(i);
    values.push_back(at.position_gradient(w) - turning[i] + at.input_force(w, state.u) +
                     at.applied_force(w) - at.dissipation_force(w));
  }
  return values;
}

}  // namespace elgen::oracle
