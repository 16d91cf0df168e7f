// Constraints: rates, Jacobian, bias, projection of a state by one Newton step, and inverse
// dynamics of constrained motions.
#include "derive/lagrangian/symmetric_solve.hpp"
#include "derive/lagrangian/turning.hpp"
#include "derive/outputs/outputs.hpp"

namespace elgen {

using GiNaC::ex;

namespace {

/// f of the position constraints.
Vector residuals(const Derivation& derivation) {
  Vector result;
  for (const ConstraintEquation& constraint : derivation.lagrangian.constraints) {
    if (constraint.is_position) result.push_back(constraint.value);
  }
  return result;
}

Vector row_of(Derivation& derivation, const ConstraintEquation& constraint) {
  const std::vector<Weighted> sum{{constraint.value, 1}};
  if (constraint.is_position) return derivation.by_position(sum);
  return gradient(derivation.definitions, sum, derivation.symbols.v);
}

/// The rows of A: all rows, or only the rows of position constraints.
Vector rows_of(Derivation& derivation, bool positions_only) {
  Vector entries;
  for (const ConstraintEquation& constraint : derivation.lagrangian.constraints) {
    if (positions_only && !constraint.is_position) continue;
    const Vector row = row_of(derivation, constraint);
    entries.insert(entries.end(), row.begin(), row.end());
  }
  return entries;
}

/// q + N dq with M dq = A^T y and A dq = -f; quaternions are normalised to length 1 afterwards.
Vector projected_coordinates(Derivation& derivation, const Vector& mass) {
  Definitions& definitions = derivation.definitions;
  ConstrainedSolve solve(derivation, mass, rows_of(derivation, true));
  const Vector change =
      solve.solve(Vector(derivation.size(), 0), negative(residuals(derivation))).x;
  Seeds seeds;
  add_seeds(seeds, derivation.symbols.v, change);
  Substitution changing(definitions, std::move(seeds));
  Seeds moved;
  for (std::size_t i = 0; i < derivation.symbols.q.size(); ++i) {
    const ex& q = derivation.symbols.q[i];
    const ex rate = changing(define(definitions, derivation.symbols.q_rates[i]));
    moved.emplace(q, define(definitions, q + rate));
  }
  Substitution moving(definitions, std::move(moved));
  return substituted(moving, definitions, normalized(derivation));
}

/// x with the dependent entries set to 0.
Vector independent_part(const std::vector<bool>& is_independent, const Vector& x) {
  Vector result(x.size(), 0);
  for (std::size_t i = 0; i < x.size(); ++i) {
    if (is_independent[i]) result[i] = x[i];
  }
  return result;
}

}  // namespace

Vector constraint_rates(Derivation& derivation) {
  Vector result;
  for (const ConstraintEquation& constraint : derivation.lagrangian.constraints) {
    result.push_back(constraint.is_position ? define(derivation.definitions,
                                                     derivation.zero_acceleration(constraint.value))
                                            : constraint.value);
  }
  return result;
}

ConstraintResidual constraint_residual(Derivation& derivation) {
  return {residuals(derivation), constraint_rates(derivation)};
}

Vector constraint_jacobian(Derivation& derivation) { return rows_of(derivation, false); }

Vector constraint_bias(Derivation& derivation) {
  Vector result = constraint_rates(derivation);
  for (ex& entry : result) entry = derivation.zero_acceleration(entry);
  return result;
}

Vector constraint_force(Derivation& derivation, const Vector& multipliers) {
  const std::size_t n = derivation.size();
  const Vector jacobian = constraint_jacobian(derivation);
  Vector result(n, 0);
  for (std::size_t k = 0; k < jacobian.size(); ++k) {
    result[k % n] += jacobian[k] * multipliers[k / n];
  }
  return result;
}

Vector stabilised(Derivation& derivation, Vector rates_of_rates) {
  const Vector rates = constraint_rates(derivation);
  for (std::size_t i = 0; i < rates.size(); ++i) {
    const ConstraintEquation& constraint = derivation.lagrangian.constraints[i];
    rates_of_rates[i] += constraint.damping * rates[i] + constraint.stiffness * constraint.value;
  }
  return rates_of_rates;
}

ProjectedState projected(Derivation& derivation) {
  Definitions& definitions = derivation.definitions;
  const Vector mass = mass_matrix(derivation);
  ProjectedState result;
  result.coordinates = projected_coordinates(derivation, mass);
  Seeds seeds;
  for (ex& coordinate : result.coordinates) coordinate = define(definitions, coordinate);
  add_seeds(seeds, derivation.symbols.q, result.coordinates);
  Substitution at_solution(definitions, std::move(seeds));
  const Vector mass_at_solution = substituted(at_solution, definitions, mass);
  const Vector jacobian = constraint_jacobian(derivation);
  ConstrainedSolve solve(derivation, mass_at_solution,
                         substituted(at_solution, definitions, jacobian));
  const Vector rates = substituted(at_solution, definitions, constraint_rates(derivation));
  const Vector change = solve.solve(Vector(derivation.size(), 0), negative(rates)).x;
  for (std::size_t i = 0; i < change.size(); ++i) {
    result.rates.push_back(derivation.symbols.v[i] + change[i]);
  }
  return result;
}

ConstrainedInverse constrained_inverse_dynamics(Derivation& derivation) {
  Definitions& definitions = derivation.definitions;
  const std::size_t n = derivation.size();
  const std::size_t inputs = derivation.symbols.u.size();
  Vector force = inverse_dynamics(derivation);
  for (ex& entry : force) entry = define(definitions, entry);
  const Vector b = input_matrix(derivation);
  const Vector mass = mass_matrix(derivation);
  ConstrainedSolve solve(derivation, mass, constraint_jacobian(derivation));
  const Vector at_rest(derivation.lagrangian.constraints.size(), 0);
  Vector matrix(inputs * inputs);
  Vector right(inputs);
  for (std::size_t j = 0; j < inputs; ++j) {
    Vector column(n);
    for (std::size_t k = 0; k < n; ++k) column[k] = b[k * inputs + j];
    const Vector response = solve.solve(column, at_rest).x;  // G B e_j
    for (std::size_t k = 0; k < n; ++k) {
      right[j] += response[k] * force[k];
      for (std::size_t i = 0; i < inputs; ++i) {
        matrix[i * inputs + j] += b[k * inputs + i] * response[k];
      }
    }
  }
  ConstrainedInverse result;
  result.inputs =
      SymmetricSolve(definitions, matrix, in_order(inputs), RowsOf::inputs).solve(right);
  for (std::size_t k = 0; k < n * inputs; ++k) {
    force[k / inputs] -= b[k] * result.inputs[k % inputs];
  }
  for (ex& entry : force) entry = define(definitions, entry);
  result.multipliers = negative(solve.solve(force, at_rest).y);
  const Vector held = constraint_force(derivation, result.multipliers);
  for (std::size_t k = 0; k < n; ++k) result.unbalanced.push_back(force[k] - held[k]);
  return result;
}

Completed completed(Derivation& derivation, const OutputRequest& request) {
  Definitions& definitions = derivation.definitions;
  const std::size_t n = derivation.size();
  std::vector<bool> is_independent(n);
  for (const std::uint32_t i : request.independent) is_independent[i] = true;
  const Vector jacobian = constraint_jacobian(derivation);
  Vector of_dependent = jacobian;
  Vector identity(n * n, 0);
  for (std::size_t i = 0; i < n; ++i) identity[i * n + i] = 1;
  for (std::size_t k = 0; k < jacobian.size(); ++k) {
    if (is_independent[k % n]) of_dependent[k] = 0;
  }
  ConstrainedSolve solve(derivation, identity, of_dependent);
  const Vector given = independent_part(is_independent, derivation.symbols.v);
  Seeds without_others;
  add_seeds(without_others, derivation.symbols.v, given);
  Substitution without(definitions, std::move(without_others));
  const Vector rates_of_given = substituted(without, definitions, constraint_rates(derivation));
  Completed result;
  result.rates = solve.solve(given, negative(rates_of_given)).x;
  Seeds with_others;
  add_seeds(with_others, derivation.symbols.v, result.rates);
  Substitution with(definitions, std::move(with_others));
  Vector second_residual = substituted(with, definitions, constraint_bias(derivation));
  const Vector kept = independent_part(is_independent, derivation.symbols.a);
  for (std::size_t k = 0; k < jacobian.size(); ++k)
    second_residual[k / n] += jacobian[k] * kept[k % n];
  result.accelerations = solve.solve(kept, negative(second_residual)).x;
  return result;
}

}  // namespace elgen
