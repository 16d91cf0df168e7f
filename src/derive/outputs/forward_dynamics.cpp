// Forward dynamics: the mass matrix, the bias with the inputs acting, and the solution.
#include "derive/outputs/forward_dynamics.hpp"

#include "derive/outputs/forces.hpp"
#include "derive/outputs/matrices.hpp"

namespace elgen {

using GiNaC::ex;

namespace {

/// "acceleration_theta": the velocities bear the identifiers of their coordinates.
std::string name_of_acceleration(const Derivation& derivation, std::size_t i) {
  return "acceleration_" + derivation.velocity_identifier(i);
}

}  // namespace

Vector acceleration(Derivation& derivation, SymmetricSolve& mass) {
  Vector right_side = bias(derivation, InputForces::acting);
  for (ex& entry : right_side) entry = -entry;
  Vector result = mass.solve(right_side);
  for (std::size_t i = 0; i < result.size(); ++i) {
    name(derivation.definitions, result[i], name_of_acceleration(derivation, i));
  }
  return result;
}

ForwardDynamics forward_dynamics(Derivation& derivation) {
  SymmetricSolve mass(derivation, mass_matrix(derivation));
  ForwardDynamics result;
  result.acceleration = acceleration(derivation, mass);
  result.relative_pivots = mass.relative_pivots();
  result.diagonal = mass.diagonal();
  return result;
}

}  // namespace elgen
