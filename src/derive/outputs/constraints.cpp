// Constraints: rates, Jacobian, bias, projection of a state by one Newton step, and inverse
// dynamics of constrained motions.
#include "derive/lagrangian/symmetric_solve.hpp"
#include "derive/lagrangian/turning.hpp"
#include "derive/outputs/outputs.hpp"

namespace elgen {

using GiNaC::ex;

namespace {

/// f of the position constraints.
RealVector position_residuals(const Derivation& derivation) {
  RealVector result;
  for (const ConstraintEquation& constraint : derivation.lagrangian.constraints) {
    if (constraint.is_position) result.push_back(constraint.value);
  }
  return result;
}

RealVector constraint_row(Derivation& derivation, const ConstraintEquation& constraint) {
  const std::vector<WeightedTerm> sum{{constraint.value, 1}};
  if (constraint.is_position) return derivation.gradient_by_position(sum);
  return gradient(derivation.definitions, sum, derivation.symbols.v);
}

/// The rows of A: all rows, or only the rows of position constraints.
RealVector constraint_rows(Derivation& derivation, bool positions_only) {
  RealVector entries;
  for (const ConstraintEquation& constraint : derivation.lagrangian.constraints) {
    if (positions_only && !constraint.is_position) continue;
    const RealVector row = constraint_row(derivation, constraint);
    entries.insert(entries.end(), row.begin(), row.end());
  }
  return entries;
}

/// q + N dq with M dq = A^T y and A dq = -f; quaternions are normalised to length 1 afterwards.
RealVector projected_coordinates(Derivation& derivation, const RealVector& mass) {
  Definitions& definitions = derivation.definitions;
  ConstrainedSolver solve(derivation, mass, constraint_rows(derivation, true));
  const RealVector change =
      solve.solve(RealVector(derivation.size(), 0), negate(position_residuals(derivation))).x;
  Seeds seeds;
  add_seeds(seeds, derivation.symbols.v, change);
  Substitution changing(definitions, std::move(seeds));
  Seeds moved_coordinates;
  for (std::size_t i = 0; i < derivation.symbols.q.size(); ++i) {
    const ex& q = derivation.symbols.q[i];
    const ex rate = changing(define(definitions, derivation.symbols.q_rates[i]));
    moved_coordinates.emplace(q, define(definitions, q + rate));
  }
  Substitution moving(definitions, std::move(moved_coordinates));
  return define_and_substitute(moving, definitions, normalized(derivation));
}

/// x with the dependent entries set to 0.
RealVector independent_part(const std::vector<bool>& is_independent, const RealVector& x) {
  RealVector result(x.size(), 0);
  for (std::size_t i = 0; i < x.size(); ++i) {
    if (is_independent[i]) result[i] = x[i];
  }
  return result;
}

}  // namespace

RealVector constraint_rates(Derivation& derivation) {
  RealVector result;
  for (const ConstraintEquation& constraint : derivation.lagrangian.constraints) {
    result.push_back(
        constraint.is_position
            ? define(derivation.definitions, derivation.rate_without_acceleration(constraint.value))
            : constraint.value);
  }
  return result;
}

ConstraintResidual constraint_residual(Derivation& derivation) {
  return {position_residuals(derivation), constraint_rates(derivation)};
}

RealVector constraint_jacobian(Derivation& derivation) {
  return constraint_rows(derivation, false);
}

RealVector constraint_bias(Derivation& derivation) {
  RealVector result = constraint_rates(derivation);
  for (ex& entry : result) entry = derivation.rate_without_acceleration(entry);
  return result;
}

RealVector constraint_force(Derivation& derivation, const RealVector& multipliers) {
  const std::size_t n = derivation.size();
  const RealVector jacobian = constraint_jacobian(derivation);
  RealVector result(n, 0);
  for (std::size_t k = 0; k < jacobian.size(); ++k) {
    result[k % n] += jacobian[k] * multipliers[k / n];
  }
  return result;
}

RealVector with_stabilisation(Derivation& derivation, RealVector rates_of_rates) {
  const RealVector rates = constraint_rates(derivation);
  for (std::size_t i = 0; i < rates.size(); ++i) {
    const ConstraintEquation& constraint = derivation.lagrangian.constraints[i];
    rates_of_rates[i] += constraint.damping * rates[i] + constraint.stiffness * constraint.value;
  }
  return rates_of_rates;
}

ProjectedState projected(Derivation& derivation) {
  Definitions& definitions = derivation.definitions;
  const RealVector mass = mass_matrix(derivation);
  ProjectedState result;
  result.coordinates = projected_coordinates(derivation, mass);
  Seeds seeds;
  for (ex& coordinate : result.coordinates) coordinate = define(definitions, coordinate);
  add_seeds(seeds, derivation.symbols.q, result.coordinates);
  Substitution at_solution(definitions, std::move(seeds));
  const RealVector mass_at_solution = define_and_substitute(at_solution, definitions, mass);
  const RealVector jacobian = constraint_jacobian(derivation);
  ConstrainedSolver solve(derivation, mass_at_solution,
                          define_and_substitute(at_solution, definitions, jacobian));
  const RealVector rates =
      define_and_substitute(at_solution, definitions, constraint_rates(derivation));
  const RealVector change = solve.solve(RealVector(derivation.size(), 0), negate(rates)).x;
  for (std::size_t i = 0; i < change.size(); ++i) {
    result.rates.push_back(derivation.symbols.v[i] + change[i]);
  }
  return result;
}

ConstrainedInverseDynamics constrained_inverse_dynamics(Derivation& derivation) {
  Definitions& definitions = derivation.definitions;
  const std::size_t n = derivation.size();
  const std::size_t inputs = derivation.symbols.u.size();
  RealVector force = inverse_dynamics(derivation);
  for (ex& entry : force) entry = define(definitions, entry);
  const RealVector b = input_matrix(derivation);
  const RealVector mass = mass_matrix(derivation);
  ConstrainedSolver solve(derivation, mass, constraint_jacobian(derivation));
  const RealVector at_rest(derivation.lagrangian.constraints.size(), 0);
  RealVector matrix(inputs * inputs);
  RealVector right(inputs);
  for (std::size_t j = 0; j < inputs; ++j) {
    RealVector column(n);
    for (std::size_t k = 0; k < n; ++k) column[k] = b[k * inputs + j];
    const RealVector response = solve.solve(column, at_rest).x;  // G B e_j
    for (std::size_t k = 0; k < n; ++k) {
      right[j] += response[k] * force[k];
      for (std::size_t i = 0; i < inputs; ++i) {
        matrix[i * inputs + j] += b[k * inputs + i] * response[k];
      }
    }
  }
  ConstrainedInverseDynamics result;
  result.inputs =
      SymmetricSolver(definitions, matrix, identity_order(inputs), RowKind::inputs).solve(right);
  for (std::size_t k = 0; k < n * inputs; ++k) {
    force[k / inputs] -= b[k] * result.inputs[k % inputs];
  }
  for (ex& entry : force) entry = define(definitions, entry);
  result.multipliers = negate(solve.solve(force, at_rest).y);
  const RealVector held = constraint_force(derivation, result.multipliers);
  for (std::size_t k = 0; k < n; ++k) result.unbalanced.push_back(force[k] - held[k]);
  return result;
}

CompletedMotion completed(Derivation& derivation, const OutputRequest& request) {
  Definitions& definitions = derivation.definitions;
  const std::size_t n = derivation.size();
  std::vector<bool> is_independent(n);
  for (const std::uint32_t i : request.independent) is_independent[i] = true;
  const RealVector jacobian = constraint_jacobian(derivation);
  RealVector of_dependent = jacobian;
  RealVector identity(n * n, 0);
  for (std::size_t i = 0; i < n; ++i) identity[i * n + i] = 1;
  for (std::size_t k = 0; k < jacobian.size(); ++k) {
    if (is_independent[k % n]) of_dependent[k] = 0;
  }
  ConstrainedSolver solve(derivation, identity, of_dependent);
  const RealVector given = independent_part(is_independent, derivation.symbols.v);
  Seeds without_others;
  add_seeds(without_others, derivation.symbols.v, given);
  Substitution at_zero_dependent(definitions, std::move(without_others));
  const RealVector rates_of_given =
      define_and_substitute(at_zero_dependent, definitions, constraint_rates(derivation));
  CompletedMotion result;
  result.rates = solve.solve(given, negate(rates_of_given)).x;
  Seeds with_others;
  add_seeds(with_others, derivation.symbols.v, result.rates);
  Substitution at_solution(definitions, std::move(with_others));
  RealVector second_residual =
      define_and_substitute(at_solution, definitions, constraint_bias(derivation));
  const RealVector independent_accelerations =
      independent_part(is_independent, derivation.symbols.a);
  for (std::size_t k = 0; k < jacobian.size(); ++k)
    second_residual[k / n] += jacobian[k] * independent_accelerations[k % n];
  result.accelerations = solve.solve(independent_accelerations, negate(second_residual)).x;
  return result;
}

}  // namespace elgen
