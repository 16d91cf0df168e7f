// Hamilton's equations: solve v = M^-1 (p - b), then substitute v in functions of (q, v).
#include <utility>

#include "derive/lagrangian/symmetric_solve.hpp"
#include "derive/lagrangian/turning.hpp"
#include "derive/outputs/outputs.hpp"

namespace elgen {

using GiNaC::ex;

namespace {

/// p - b; entries are definitions.
RealVector mass_times_velocities(Derivation& derivation) {
  Seeds rest;
  for (const ex& velocity : derivation.symbols.v) rest.emplace(velocity, 0);
  Substitution at_rest(derivation.definitions, std::move(rest));
  const RealVector whole = momentum(derivation);
  RealVector result;
  for (std::size_t i = 0; i < whole.size(); ++i) {
    const ex entry = define(derivation.definitions, whole[i]);
    const ex b = define(derivation.definitions, at_rest(entry));
    result.push_back(define(derivation.definitions, derivation.symbols.momenta[i] - b));
  }
  return result;
}

/// M^-1 r, with names such as "velocity_theta".
RealVector solve_velocities(Derivation& derivation, const RealVector& right_side) {
  SymmetricSolver mass(derivation.definitions, mass_matrix(derivation),
                       velocity_elimination_order(derivation), RowKind::velocities);
  RealVector result = mass.solve(right_side);
  for (std::size_t i = 0; i < result.size(); ++i) {
    name_definition(derivation.definitions, result[i],
                    "velocity_" + derivation.velocity_identifier(i));
  }
  return result;
}

/// N^T dL/dq - [w]x p + B u + Q - dD/dv as a function of q, v and p.
RealVector rates_of_momenta(Derivation& derivation) {
  RealVector result = position_gradient(derivation);
  const RealVector turning = hamel_force(derivation, derivation.symbols.momenta);
  const RealVector applied = applied_force(derivation, InputForces::acting);
  const RealVector damping = dissipation(derivation);
  for (std::size_t i = 0; i < result.size(); ++i) result[i] += applied[i] - turning[i] - damping[i];
  return result;
}

/// `values` with v replaced by `velocities`.
RealVector substitute_velocities(Derivation& derivation, const RealVector& velocities,
                                 const RealVector& values) {
  Seeds seeds;
  add_seeds(seeds, derivation.symbols.v, velocities);
  Substitution at_velocities(derivation.definitions, std::move(seeds));
  return define_and_substitute(at_velocities, derivation.definitions, values);
}

}  // namespace

RealVector velocities_of_momenta(Derivation& derivation) {
  return solve_velocities(derivation, mass_times_velocities(derivation));
}

ex hamiltonian(Derivation& derivation) {
  const RealVector p = mass_times_velocities(derivation);
  const RealVector v = solve_velocities(derivation, p);
  GiNaC::exvector terms{energy_at_rest(derivation)};
  for (std::size_t i = 0; i < v.size(); ++i) terms.push_back(p[i] * v[i] / 2);
  return GiNaC::add(terms);
}

HamiltonEquations hamilton_equations(Derivation& derivation) {
  const RealVector v = velocities_of_momenta(derivation);
  const RealVector rates = rates_of_momenta(derivation);
  HamiltonEquations result;
  result.coordinate_rates = substitute_velocities(derivation, v, coordinate_rates(derivation));
  result.momentum_rates = substitute_velocities(derivation, v, rates);
  return result;
}

}  // namespace elgen
