// Forward dynamics by factorising M and S = A M^-1 A^T, or by articulated bodies. Derivatives of
// the dynamics: bodies in frames by columns (tree_matrices.hpp), everything else by forward passes.
#include <string>
#include <utility>

#include "derive/formulate/name_scope.hpp"
#include "derive/lagrangian/symmetric_solve.hpp"
#include "derive/outputs/outputs.hpp"
#include "derive/tree/articulated.hpp"
#include "derive/tree/tree_matrices.hpp"
#include "elgen/compose.hpp"

namespace elgen {

using GiNaC::ex;

namespace {

/// Names the definitions of accelerations, e.g. "acceleration_theta".
void name_accelerations(Derivation& derivation, const Vector& accelerations) {
  for (std::size_t i = 0; i < accelerations.size(); ++i) {
    name(derivation.definitions, accelerations[i],
         "acceleration_" + derivation.velocity_identifier(i));
  }
}

/// Solves for accelerations and multipliers with one factorisation of M and one of S.
class Dynamics {
 public:
  explicit Dynamics(Derivation& derivation)
      : derivation_(derivation), solve_(solve_of(derivation)) {}

  [[nodiscard]] ConstrainedSolve::Solution motion() {
    const Vector bias_of_constraints = stabilised(derivation_, constraint_bias(derivation_));
    ConstrainedSolve::Solution result = solve_.solve(
        negative(bias(derivation_, InputForces::acting)), negative(bias_of_constraints));
    name_accelerations(derivation_, result.x);
    for (std::size_t i = 0; i < result.y.size(); ++i) {
      name(derivation_.definitions, result.y[i],
           "multiplier_" + identifier_of(derivation_.lagrangian.leaves.multipliers[i]));
    }
    return result;
  }

  /// Solves M x = f + A^T y, A x = s for each column f of `forces` and s of `second_residual`.
  /// Returns x, n x `columns`, row-major.
  [[nodiscard]] Vector responses(const Vector& forces, const Vector& second_residual,
                                 std::size_t columns) {
    const std::size_t n = derivation_.size();
    Vector result(n * columns);
    for (std::size_t j = 0; j < columns; ++j) {
      const NameScope response(derivation_.definitions, "response_" + std::to_string(j + 1));
      const Vector x =
          solve_.solve(column_of(forces, j, columns), column_of(second_residual, j, columns)).x;
      for (std::size_t i = 0; i < n; ++i) result[i * columns + j] = x[i];
    }
    return result;
  }

  [[nodiscard]] const ConstrainedSolve& solve() const { return solve_; }

 private:
  /// Factorises M and S. Separate statements fix the order of definitions, because compilers
  /// evaluate arguments in different orders.
  static ConstrainedSolve solve_of(Derivation& derivation) {
    const Vector mass = mass_matrix(derivation);
    return {derivation, mass, constraint_jacobian(derivation)};
  }

  static Vector column_of(const Vector& matrix, std::size_t column, std::size_t columns) {
    Vector result;
    for (std::size_t k = column; k < matrix.size(); k += columns) result.push_back(matrix[k]);
    return result;
  }

  Derivation& derivation_;
  ConstrainedSolve solve_;
};

/// The substitution of `motion`, the solution of the forward dynamics, for the leaves a and lambda.
Substitution at_motion(Derivation& derivation, const ConstrainedSolve::Solution& motion) {
  Seeds seeds;
  add_seeds(seeds, derivation.symbols.a, motion.x);
  add_seeds(seeds, derivation.symbols.multipliers, motion.y);
  return {derivation.definitions, std::move(seeds)};
}

Vector unit_vector(std::size_t size, std::size_t j) {
  Vector unit(size, 0);
  unit[j] = 1;
  return unit;
}

/// The diagonal that [energy] T and armatures add to M; none if they add off-diagonal entries.
std::optional<Vector> added_to_diagonal(Derivation& derivation) {
  const Vector momentum = derivation.by_velocity(weighted(derivation.graded().kinetic2, 1));
  Vector result;
  for (std::size_t j = 0; j < momentum.size(); ++j) {
    Tangent velocity = derivation.unit_velocity(j);
    for (std::size_t i = 0; i < momentum.size(); ++i) {
      const ex slope = velocity(momentum[i]);
      if (i == j) {
        result.push_back(define(derivation.definitions, slope));
      } else if (!slope.is_zero()) {
        return std::nullopt;
      }
    }
  }
  return result;
}

/// The matrix whose column j is d values/ds along direction(j); one column per velocity.
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

/// d values/dq and d values/dv.
InverseDerivatives derivatives(Derivation& derivation, const Vector& values) {
  InverseDerivatives result;
  result.by_position =
      columns(derivation, values, [&](std::size_t j) { return derivation.displacement(j); });
  result.by_velocity =
      columns(derivation, values, [&](std::size_t j) { return derivation.unit_velocity(j); });
  return result;
}

/// d(M a + bias - B u - A^T lambda)/dq and /dv; without B u and A^T lambda if the inputs are
/// absent.
InverseDerivatives residual_derivatives(Derivation& derivation, InputForces inputs) {
  const bool by_columns = has_linear_variables(tree_of(derivation));
  Vector rest = residual(derivation, inputs, by_columns ? Bodies::without_frames : Bodies::all);
  if (inputs == InputForces::acting) {
    const Vector held = constraint_force(derivation, derivation.symbols.multipliers);
    for (std::size_t i = 0; i < rest.size(); ++i) rest[i] -= held[i];
  }
  for (ex& entry : rest) entry = define(derivation.definitions, entry);
  InverseDerivatives result = derivatives(derivation, rest);
  if (!by_columns) return result;
  const TreeDerivatives of_frames = tree_derivatives(tree_of(derivation), derivation.motion);
  add_to_dense(of_frames.by_position, result.by_position, derivation.size());
  add_to_dense(of_frames.by_velocity, result.by_velocity, derivation.size());
  return result;
}

/// d(A a + gamma + 2 zeta omega r + omega^2 f)/dq and /dv.
InverseDerivatives constraint_derivatives(Derivation& derivation) {
  Vector second_rates = constraint_rates(derivation);
  for (ex& entry : second_rates) entry = derivation.motion(entry);
  second_rates = stabilised(derivation, std::move(second_rates));
  for (ex& entry : second_rates) entry = define(derivation.definitions, entry);
  return derivatives(derivation, second_rates);
}

/// Sets -[w]x in the upper left block of A, which has 2 n_v columns.
void add_turning_of_displacement(const Symbols& symbols, const RotationPlace& rotation, Vector& a) {
  const std::size_t columns = 2 * symbols.v.size();
  const std::size_t first = rotation.first_velocity;
  for (const auto& [k, i, j] : cyclic_axes) {
    a[(first + k) * columns + first + i] = symbols.v[first + j];
    a[(first + k) * columns + first + j] = -symbols.v[first + i];
  }
}

/// The upper rows of A: d(dq)/dt = dv, and d(dq)/dt = dv - w x dq for rotations.
Vector upper_rows(const Derivation& derivation) {
  const std::size_t n = derivation.size();
  Vector result(2 * n * n, 0);
  for (std::size_t i = 0; i < n; ++i) result[i * 2 * n + n + i] = 1;
  for (const RotationPlace& rotation : derivation.symbols.rotations) {
    add_turning_of_displacement(derivation.symbols, rotation, result);
  }
  return result;
}

}  // namespace

ForwardDynamics forward_dynamics(Derivation& derivation) {
  Dynamics dynamics(derivation);
  const ConstrainedSolve::Solution motion = dynamics.motion();
  return {motion.x, dynamics.solve().relative_pivots(), motion.y, dynamics.solve().diagonal()};
}

std::optional<ArticulatedDynamics> articulated_dynamics(Derivation& derivation, bool has_pivots) {
  const Lagrangian& lagrangian = derivation.lagrangian;
  const bool is_tree = lagrangian.masses.empty() && lagrangian.lagrangian.empty() &&
                       lagrangian.constraints.empty() && !lagrangian.tree.bodies.empty();
  if (!is_tree || !lagrangian.quadratic || !lagrangian.eliminates_last_first) return std::nullopt;
  const std::optional<Vector> armatures = added_to_diagonal(derivation);
  if (!armatures) return std::nullopt;
  Tree& tree = tree_of(derivation);
  const auto joints = tree_joints(tree);
  if (!joints) return std::nullopt;
  const Vector forces = negative(bias(derivation, InputForces::acting, Bodies::without_frames));
  const ArticulatedMotion motion =
      articulated_motion(tree, *joints, forces, *armatures, has_pivots);
  name_accelerations(derivation, motion.acceleration);
  Vector relative_pivots;
  for (std::size_t i = 0; i < motion.diagonal.size(); ++i) {
    relative_pivots.push_back(motion.pivots[i] / motion.diagonal[i]);
  }
  return ArticulatedDynamics{{motion.acceleration, relative_pivots, {}, motion.diagonal},
                             operations_of_factorisation(tree, *joints)};
}

Vector along_motion(Derivation& derivation, const Vector& values) {
  Substitution at_solution = at_motion(derivation, Dynamics(derivation).motion());
  return substituted(at_solution, derivation.definitions, values);
}

InverseDerivatives inverse_dynamics_derivatives(Derivation& derivation) {
  return residual_derivatives(derivation, InputForces::absent);
}

ForwardDerivatives forward_dynamics_derivatives(Derivation& derivation) {
  Dynamics dynamics(derivation);
  const ConstrainedSolve::Solution motion = dynamics.motion();
  InverseDerivatives of_forces = residual_derivatives(derivation, InputForces::acting);
  InverseDerivatives of_constraints = constraint_derivatives(derivation);
  Substitution at_solution = at_motion(derivation, motion);
  for (InverseDerivatives* const derivatives : {&of_forces, &of_constraints}) {
    for (Vector* const entries : {&derivatives->by_position, &derivatives->by_velocity}) {
      for (ex& entry : *entries) entry = -at_solution(entry);
    }
  }
  const Vector forces_of_inputs = input_matrix(derivation);
  const std::size_t n = derivation.size();
  const std::size_t inputs = derivation.symbols.u.size();
  const Vector at_rest(derivation.lagrangian.constraints.size() * inputs, 0);
  ForwardDerivatives result;
  result.by_position = dynamics.responses(of_forces.by_position, of_constraints.by_position, n);
  result.by_velocity = dynamics.responses(of_forces.by_velocity, of_constraints.by_velocity, n);
  result.by_input = dynamics.responses(forces_of_inputs, at_rest, inputs);
  return result;
}

std::optional<ResponseParts> response_parts(Derivation& derivation) {
  const std::size_t n = derivation.size();
  if (n < min_composed_velocities || !derivation.lagrangian.constraints.empty())
    return std::nullopt;
  ResponseParts parts;
  parts.mass = mass_matrix(derivation);
  for (std::size_t i = 0; i < n; ++i) {
    if (parts.mass[i * n + i].is_zero()) throw ZeroPivot(RowsOf::velocities, i, true);
  }
  parts.force = negative(bias(derivation, InputForces::acting));
  const InverseDerivatives rest = residual_derivatives(derivation, InputForces::acting);
  parts.forces = {negative(rest.by_position), negative(rest.by_velocity), input_matrix(derivation)};
  parts.rates = upper_rows(derivation);
  return parts;
}

Vector input_force_derivatives(Derivation& derivation) {
  const std::size_t inputs = derivation.symbols.u.size();
  const Vector b = input_matrix(derivation);
  Vector force(derivation.size(), 0);
  for (std::size_t k = 0; k < b.size(); ++k) {
    force[k / inputs] += b[k] * derivation.symbols.u[k % inputs];
  }
  for (ex& entry : force) entry = define(derivation.definitions, entry);
  return columns(derivation, force, [&](std::size_t j) { return derivation.displacement(j); });
}

Vector inverse_mass_matrix(Derivation& derivation) {
  const std::size_t n = derivation.size();
  const Vector mass = mass_matrix(derivation);
  SymmetricSolve solve(derivation.definitions, mass, order_of_velocities(derivation),
                       RowsOf::velocities);
  Vector entries(n * n);
  for (std::size_t j = 0; j < n; ++j) {
    const Vector column = solve.solve(unit_vector(n, j));
    for (std::size_t i = j; i < n; ++i) entries[i * n + j] = entries[j * n + i] = column[i];
  }
  return entries;
}

OperationalDynamics operational_dynamics(Derivation& derivation, const Vector& jacobian,
                                         const Vector& bias_of_task) {
  const std::size_t n = derivation.size();
  const std::size_t k = bias_of_task.size();
  const Vector mass = mass_matrix(derivation);
  ConstrainedSolve solve(derivation, mass, jacobian);
  OperationalDynamics result{Vector(k * k), Vector(n * k), {}, {}};
  for (std::size_t j = 0; j < k; ++j) {
    const ConstrainedSolve::Solution column = solve.solve(Vector(n, 0), unit_vector(k, j));
    for (std::size_t i = j; i < k; ++i) {
      result.inertia[i * k + j] = result.inertia[j * k + i] = column.y[i];
    }
    for (std::size_t i = 0; i < n; ++i) result.inverse_jacobian[i * k + j] = column.x[i];
  }
  const Vector force = negative(bias(derivation));
  result.bias = solve.solve(force, negative(bias_of_task)).y;
  result.relative_pivots = solve.relative_pivots_of_constraints();
  return result;
}

Linearization linearization(Derivation& derivation) {
  const ForwardDerivatives of_acceleration = forward_dynamics_derivatives(derivation);
  const std::size_t n = derivation.size();
  const std::size_t inputs = derivation.symbols.u.size();
  Linearization result;
  result.a = upper_rows(derivation);
  result.a.resize(4 * n * n, 0);
  result.b.assign(2 * n * inputs, 0);
  for (std::size_t i = 0; i < n; ++i) {
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
