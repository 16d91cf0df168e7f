// routh: removes cyclic coordinates from a Lagrangian; their momenta p become parameters.
//
//     before    L = 1/2*m*r_dot^2 + 1/2*m*r^2*phi_dot^2 - V(r)        phi at the momentum p_phi
//     after     R = 1/2*m*r_dot^2 - V(r) - 1/2*p_phi^2/(m*r^2)
//
//     R = L0 - 1/2 w.v_c,   M_cc v_c = w = p - b        with L0 = L and b = dL/dv_c at v_c = 0
//
// L does not depend on a cyclic coordinate, so 0 is substituted for it. Source: Goldstein, Poole,
// Safko, Classical Mechanics, 3rd ed., sec. 8.3.
#include <utility>

#include "derive/specialise/passes.hpp"

namespace elgen {

namespace {

using GiNaC::ex;

/// Solves A x = b by elimination without pivoting; every entry is a definition. Throws GiNaC's
/// pole_error if a pivot is 0.
std::vector<ex> solve_linear(Definitions& definitions, std::vector<ex> a, std::vector<ex> b) {
  const std::size_t n = b.size();
  std::vector<ex> reciprocals;
  for (std::size_t k = 0; k < n; ++k) {
    reciprocals.push_back(define(definitions, 1 / a[k * n + k]));
    for (std::size_t i = k + 1; i < n; ++i) {
      const ex factor = define(definitions, a[i * n + k] * reciprocals[k]);
      for (std::size_t j = k + 1; j < n; ++j) {
        a[i * n + j] = define(definitions, a[i * n + j] - factor * a[k * n + j]);
      }
      b[i] = define(definitions, b[i] - factor * b[k]);
    }
  }
  for (std::size_t k = n; k-- > 0;) {
    for (std::size_t j = k + 1; j < n; ++j) b[k] -= a[k * n + j] * b[j];
    b[k] = define(definitions, b[k] * reciprocals[k]);
  }
  return b;
}

/// Moves the terms of T and -V to L.
void join_energies(Lagrangian& lagrangian) {
  EnergyTerms& whole = lagrangian.lagrangian;
  for (const EnergyTerm& term : lagrangian.kinetic) whole.push_back(term);
  for (const auto& [value, origin] : lagrangian.potential) whole.push_back({-value, origin});
  lagrangian.kinetic.clear();
  lagrangian.potential.clear();
}

/// M_cc (`mass`) and w (`excess`) at v_c = 0, as definitions.
struct CyclicEquations {
  std::vector<ex> mass = {};
  std::vector<ex> excess = {};
};

CyclicEquations cyclic_equations(UnreducedLagrangian& lagrangian, const Seeds& cyclic_values) {
  Definitions& definitions = lagrangian.definitions;
  std::vector<ex> rates;
  for (const HeldCoordinate& cyclic : lagrangian.cyclic) {
    rates.push_back(lagrangian.symbols.v[cyclic.velocity]);
  }
  std::vector<WeightedTerm> terms;
  for (const EnergyTerm& term : lagrangian.lagrangian) terms.push_back({term.value, 1});
  const std::vector<ex> momenta = gradient(definitions, terms, rates);
  Substitution at_rest(definitions, cyclic_values);
  CyclicEquations equations;
  for (std::size_t i = 0; i < rates.size(); ++i) {
    const ex momentum = define(definitions, momenta[i]);
    for (const ex& entry : gradient(definitions, {{momentum, 1}}, rates)) {
      equations.mass.push_back(define(definitions, at_rest(define(definitions, entry))));
    }
    const ex excess = lagrangian.cyclic[i].values.front() - at_rest(momentum);
    equations.excess.push_back(define(definitions, excess));
  }
  return equations;
}

}  // namespace

void apply_routh_reduction(UnreducedLagrangian& lagrangian) {
  write_energy_sums(lagrangian);
  join_energies(lagrangian);
  Seeds cyclic_values;
  for (const HeldCoordinate& cyclic : lagrangian.cyclic) {
    cyclic_values.emplace(lagrangian.symbols.q[cyclic.coordinate], 0);
    cyclic_values.emplace(lagrangian.symbols.v[cyclic.velocity], 0);
    cyclic_values.emplace(lagrangian.symbols.a[cyclic.velocity], 0);
  }
  const CyclicEquations equations = cyclic_equations(lagrangian, cyclic_values);
  std::vector<ex> rates = solve_linear(lagrangian.definitions, equations.mass, equations.excess);
  remove_variables(lagrangian, lagrangian.cyclic, cyclic_values);
  for (std::size_t i = 0; i < rates.size(); ++i) {
    lagrangian.lagrangian.push_back({-equations.excess[i] * rates[i] / 2, EnergyOrigin::momentum});
  }
  lagrangian.cyclic_rates = std::move(rates);
}

}  // namespace elgen
