// LDL^T over definitions: every W, D, L and z is one.
#include "derive/forward_dynamics.hpp"

#include "derive/forces.hpp"
#include "derive/matrices.hpp"

namespace elgen {

using GiNaC::ex;

namespace {

/// Lower triangles, row-major; entries are atomic (symbols, numbers).
struct Factors {
  std::size_t n = 0;
  Vector mass;         ///< M, all of it
  Vector lower;        ///< L, unit diagonal not stored
  Vector unscaled;     ///< W = L D
  Vector pivots;       ///< D
  Vector reciprocals;  ///< 1 / D
};

/// "acceleration_theta" of the velocity "theta_dot".
std::string name_of_acceleration(const ex& velocity) {
  std::string name = GiNaC::ex_to<GiNaC::symbol>(velocity).get_name();
  name.resize(name.size() - std::string_view("_dot").size());
  return "acceleration_" + name;
}

ex entry(Derivation& derivation, const Factors& factors, std::size_t i, std::size_t j) {
  GiNaC::exvector terms{factors.mass[i * factors.n + j]};
  for (std::size_t k = 0; k < j; ++k) {
    terms.push_back(-factors.lower[j * factors.n + k] * factors.unscaled[i * factors.n + k]);
  }
  return define(derivation.definitions, GiNaC::add(terms));
}

Factors factorise(Derivation& derivation) {
  Factors factors;
  const std::size_t n = factors.n = derivation.size();
  for (const ex& value : mass_matrix(derivation)) {
    factors.mass.push_back(define(derivation.definitions, value));
  }
  factors.lower.assign(n * n, 0);
  factors.unscaled.assign(n * n, 0);
  for (std::size_t j = 0; j < n; ++j) {
    factors.pivots.push_back(entry(derivation, factors, j, j));
    factors.reciprocals.push_back(define(derivation.definitions, 1 / factors.pivots[j]));
    for (std::size_t i = j + 1; i < n; ++i) {
      const ex unscaled = entry(derivation, factors, i, j);
      factors.unscaled[i * n + j] = unscaled;
      factors.lower[i * n + j] = define(derivation.definitions, unscaled * factors.reciprocals[j]);
    }
  }
  return factors;
}

}  // namespace

ForwardDynamics forward_dynamics(Derivation& derivation) {
  const Factors factors = factorise(derivation);
  const std::size_t n = factors.n;
  Vector z = bias(derivation, Inputs::acting);
  for (std::size_t i = 0; i < n; ++i) {
    GiNaC::exvector terms{-z[i]};
    for (std::size_t k = 0; k < i; ++k) terms.push_back(-factors.lower[i * n + k] * z[k]);
    z[i] = define(derivation.definitions, GiNaC::add(terms));
  }
  ForwardDynamics result;
  result.acceleration.assign(n, 0);
  for (std::size_t i = n; i-- > 0;) {
    GiNaC::exvector terms{z[i] * factors.reciprocals[i]};
    for (std::size_t k = i + 1; k < n; ++k) {
      terms.push_back(-factors.lower[k * n + i] * result.acceleration[k]);
    }
    result.acceleration[i] = define(derivation.definitions, GiNaC::add(terms),
                                    {name_of_acceleration(derivation.symbols.v[i]), {}});
  }
  for (std::size_t i = 0; i < n; ++i) {
    result.relative_pivots.push_back(factors.pivots[i] / factors.mass[i * n + i]);
  }
  return result;
}

}  // namespace elgen
