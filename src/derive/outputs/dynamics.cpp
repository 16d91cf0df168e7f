// Forward dynamics: the mass matrix, the bias with the inputs acting, and the solution.
// Derivatives: columns of the frames, forward passes over the rest.
#include "derive/lagrangian/symmetric_solve.hpp"
#include "derive/outputs/outputs.hpp"
#include "derive/tree/tree_matrices.hpp"

namespace elgen {

using GiNaC::ex;

namespace {

/// By a factorisation of M. They are named "acceleration_theta": the velocities bear the
/// identifiers of their coordinates.
Vector acceleration(Derivation& derivation, SymmetricSolve& mass) {
  Vector right_side = bias(derivation, InputForces::acting);
  for (ex& entry : right_side) entry = -entry;
  Vector result = mass.solve(right_side);
  for (std::size_t i = 0; i < result.size(); ++i) {
    name(derivation.definitions, result[i], "acceleration_" + derivation.velocity_identifier(i));
  }
  return result;
}

/// d values/d(direction) for every direction, as columns.
template <class Direction>
Vector columns(Derivation& derivation, const Vector& values, const Direction& direction) {
  const std::size_t n = derivation.size();
  Vector entries(values.size() * n);
  for (std::size_t j = 0; j < n; ++j) {
    Tangent along = direction(j);
    for (std::size_t i = 0; i < values.size(); ++i) entries[i * n + j] = along(values[i]);
  }
  return entries;
}

/// d(M a + bias - B u)/dq and /dv; B u only where the inputs act.
InverseDerivatives residual_derivatives(Derivation& derivation, InputForces inputs) {
  const bool by_columns = has_linear_variables(tree_of(derivation));
  Vector rest = residual(derivation, inputs, by_columns ? Bodies::without_frames : Bodies::all);
  for (ex& entry : rest) entry = define(derivation.definitions, entry);
  InverseDerivatives result;
  result.by_position =
      columns(derivation, rest, [&](std::size_t j) { return derivation.displacement(j); });
  result.by_velocity =
      columns(derivation, rest, [&](std::size_t j) { return derivation.unit_velocity(j); });
  if (!by_columns) return result;
  const TreeDerivatives of_frames = tree_derivatives(tree_of(derivation), derivation.motion);
  add(of_frames.by_position, result.by_position, derivation.size());
  add(of_frames.by_velocity, result.by_velocity, derivation.size());
  return result;
}

/// -M^-1 X, column by column.
Vector negative_solutions(SymmetricSolve& mass, const Vector& x, std::size_t columns) {
  Vector result(x.size());
  const std::size_t rows = columns == 0 ? 0 : x.size() / columns;
  for (std::size_t j = 0; j < columns; ++j) {
    Vector column;
    for (std::size_t i = 0; i < rows; ++i) column.push_back(-x[i * columns + j]);
    const Vector solution = mass.solve(column);
    for (std::size_t i = 0; i < rows; ++i) result[i * columns + j] = solution[i];
  }
  return result;
}

/// -[w]x in the upper left block of A.
void add_turning_of_displacement(const Symbols& symbols, const RotationPlace& rotation, Vector& a) {
  const std::size_t columns = 2 * symbols.v.size();
  const std::size_t first = rotation.first_velocity;
  for (const auto& [k, i, j] : cyclic_axes) {
    a[(first + k) * columns + first + i] = symbols.v[first + j];
    a[(first + k) * columns + first + j] = -symbols.v[first + i];
  }
}

}  // namespace

ForwardDynamics forward_dynamics(Derivation& derivation) {
  SymmetricSolve mass(derivation, mass_matrix(derivation));
  ForwardDynamics result;
  result.acceleration = acceleration(derivation, mass);
  result.relative_pivots = mass.relative_pivots();
  result.diagonal = mass.diagonal();
  return result;
}

InverseDerivatives inverse_dynamics_derivatives(Derivation& derivation) {
  return residual_derivatives(derivation, InputForces::absent);
}

ForwardDerivatives forward_dynamics_derivatives(Derivation& derivation) {
  SymmetricSolve mass(derivation, mass_matrix(derivation));
  const Vector solved = acceleration(derivation, mass);
  InverseDerivatives of_residual = residual_derivatives(derivation, InputForces::acting);
  Seeds accelerations;
  for (std::size_t i = 0; i < solved.size(); ++i) {
    accelerations.emplace(derivation.symbols.a[i], solved[i]);
  }
  Substitution at_acceleration(derivation.definitions, accelerations);
  for (ex& entry : of_residual.by_position) entry = at_acceleration(entry);
  for (ex& entry : of_residual.by_velocity) entry = at_acceleration(entry);
  Vector inputs = input_matrix(derivation);
  for (ex& entry : inputs) entry = -entry;
  const std::size_t n = derivation.size();
  ForwardDerivatives result;
  result.by_position = negative_solutions(mass, of_residual.by_position, n);
  result.by_velocity = negative_solutions(mass, of_residual.by_velocity, n);
  result.by_input = negative_solutions(mass, inputs, derivation.symbols.u.size());
  return result;
}

Linearization linearization(Derivation& derivation) {
  const ForwardDerivatives of_acceleration = forward_dynamics_derivatives(derivation);
  const std::size_t n = derivation.size();
  const std::size_t inputs = derivation.symbols.u.size();
  Linearization result;
  result.a.assign(4 * n * n, 0);
  result.b.assign(2 * n * inputs, 0);
  for (const RotationPlace& rotation : derivation.symbols.rotations) {
    add_turning_of_displacement(derivation.symbols, rotation, result.a);
  }
  for (std::size_t i = 0; i < n; ++i) {
    result.a[i * 2 * n + n + i] = 1;
    for (std::size_t j = 0; j < n; ++j) {
      result.a[(n + i) * 2 * n + j] = of_acceleration.by_position[i * n + j];
      result.a[(n + i) * 2 * n + n + j] = of_acceleration.by_velocity[i * n + j];
    }
    for (std::size_t j = 0; j < inputs; ++j) {
      result.b[(n + i) * inputs + j] = of_acceleration.by_input[i * inputs + j];
    }
  }
  return result;
}

}  // namespace elgen
