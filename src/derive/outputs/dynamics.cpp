// Forward dynamics by factorising M and S = A M^-1 A^T, or by articulated bodies. Derivatives of
// the dynamics: tree_derivatives() for bodies in frames, forward passes for all other terms.
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
void name_accelerations(Derivation& derivation, const RealVector& accelerations) {
  for (std::size_t i = 0; i < accelerations.size(); ++i) {
    name_definition(derivation.definitions, accelerations[i],
                    "acceleration_" + derivation.velocity_identifier(i));
  }
}

/// Solves for accelerations and multipliers with one factorisation of M and one of S.
class AccelerationSolver {
 public:
  explicit AccelerationSolver(Derivation& derivation)
      : derivation_(derivation), solver_(make_solver(derivation)) {}

  [[nodiscard]] ConstrainedSolver::Solution solve_motion() {
    const RealVector bias_of_constraints =
        with_stabilisation(derivation_, constraint_bias(derivation_));
    ConstrainedSolver::Solution result =
        solver_.solve(negate(bias(derivation_, InputForces::acting)), negate(bias_of_constraints));
    name_accelerations(derivation_, result.x);
    for (std::size_t i = 0; i < result.y.size(); ++i) {
      name_definition(derivation_.definitions, result.y[i],
                      "multiplier_" + identifier_of(derivation_.lagrangian.leaves.multipliers[i]));
    }
    return result;
  }

  /// Solves M x = f + A^T y, A x = s for each column f of `forces` and s of `second_residual`.
  /// Returns x, n x `columns`, row-major.
  [[nodiscard]] RealVector solve_columns(const RealVector& forces,
                                         const RealVector& second_residual, std::size_t columns) {
    const std::size_t n = derivation_.size();
    RealVector result(n * columns);
    for (std::size_t j = 0; j < columns; ++j) {
      const NameScope response(derivation_.definitions, "response_" + std::to_string(j + 1));
      const RealVector x =
          solver_.solve(column_of(forces, j, columns), column_of(second_residual, j, columns)).x;
      for (std::size_t i = 0; i < n; ++i) result[i * columns + j] = x[i];
    }
    return result;
  }

  [[nodiscard]] const ConstrainedSolver& solver() const { return solver_; }

 private:
  /// Factorises M and S. Separate statements fix the order of definitions, because compilers
  /// evaluate arguments in different orders.
  static ConstrainedSolver make_solver(Derivation& derivation) {
    const RealVector mass = mass_matrix(derivation);
    return {derivation, mass, constraint_jacobian(derivation)};
  }

  static RealVector column_of(const RealVector& matrix, std::size_t column, std::size_t columns) {
    RealVector result;
    for (std::size_t k = column; k < matrix.size(); k += columns) result.push_back(matrix[k]);
    return result;
  }

  Derivation& derivation_;
  ConstrainedSolver solver_;
};

/// The substitution of `motion`, the solution of the forward dynamics, for the leaves a and lambda.
Substitution motion_substitution(Derivation& derivation,
                                 const ConstrainedSolver::Solution& motion) {
  Seeds seeds;
  add_seeds(seeds, derivation.symbols.a, motion.x);
  add_seeds(seeds, derivation.symbols.multipliers, motion.y);
  return {derivation.definitions, std::move(seeds)};
}

RealVector unit_vector(std::size_t size, std::size_t j) {
  RealVector unit(size, 0);
  unit[j] = 1;
  return unit;
}

/// The diagonal that the T of [energy] and the armatures add to M; none if the T of [energy] adds
/// entries off the diagonal.
std::optional<RealVector> energy_mass_diagonal(Derivation& derivation) {
  const RealVector momentum =
      derivation.gradient_by_velocity(weighted_terms(derivation.graded_energies().kinetic2, 1));
  RealVector result;
  for (std::size_t j = 0; j < momentum.size(); ++j) {
    Tangent velocity = derivation.velocity_tangent(j);
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
RealVector directional_derivatives(Derivation& derivation, const RealVector& values,
                                   const Direction& direction) {
  const std::size_t n = derivation.size();
  RealVector entries(values.size() * n);
  for (std::size_t j = 0; j < n; ++j) {
    Tangent along = direction(j);
    for (std::size_t i = 0; i < values.size(); ++i) entries[i * n + j] = along(values[i]);
  }
  return entries;
}

/// d values/dq and d values/dv.
InverseDerivatives state_derivatives(Derivation& derivation, const RealVector& values) {
  InverseDerivatives result;
  result.by_position = directional_derivatives(
      derivation, values, [&](std::size_t j) { return derivation.displacement_tangent(j); });
  result.by_velocity = directional_derivatives(
      derivation, values, [&](std::size_t j) { return derivation.velocity_tangent(j); });
  return result;
}

/// d(M a + bias - B u - A^T lambda)/dq and /dv; without B u and A^T lambda if the inputs are
/// absent.
InverseDerivatives residual_derivatives(Derivation& derivation, InputForces inputs) {
  const bool by_columns = has_linear_variables(tree_of(derivation));
  RealVector rest = dynamics_residual(
      derivation, inputs, by_columns ? BodySelection::outside_frames : BodySelection::all);
  if (inputs == InputForces::acting) {
    const RealVector held = constraint_force(derivation, derivation.symbols.multipliers);
    for (std::size_t i = 0; i < rest.size(); ++i) rest[i] -= held[i];
  }
  for (ex& entry : rest) entry = define(derivation.definitions, entry);
  InverseDerivatives result = state_derivatives(derivation, rest);
  if (!by_columns) return result;
  const TreeDerivatives of_frames = tree_derivatives(tree_of(derivation), derivation.motion_rate);
  add_to_dense(of_frames.by_position, result.by_position, derivation.size());
  add_to_dense(of_frames.by_velocity, result.by_velocity, derivation.size());
  return result;
}

/// d(A a + gamma + 2 zeta omega r + omega^2 f)/dq and /dv.
InverseDerivatives constraint_derivatives(Derivation& derivation) {
  RealVector second_rates = constraint_rates(derivation);
  for (ex& entry : second_rates) entry = derivation.motion_rate(entry);
  second_rates = with_stabilisation(derivation, std::move(second_rates));
  for (ex& entry : second_rates) entry = define(derivation.definitions, entry);
  return state_derivatives(derivation, second_rates);
}

/// Sets -[w]x in the upper left block of A, which has 2 n_v columns.
void add_rotation_block(const Symbols& symbols, const RotationPlace& rotation, RealVector& a) {
  const std::size_t columns = 2 * symbols.v.size();
  const std::size_t first = rotation.first_velocity;
  for (const auto& [k, i, j] : cyclic_axes) {
    a[(first + k) * columns + first + i] = symbols.v[first + j];
    a[(first + k) * columns + first + j] = -symbols.v[first + i];
  }
}

/// The upper rows of A: d(dq)/dt = dv, and d(dq)/dt = dv - w x dq for rotations.
RealVector upper_linearization_rows(const Derivation& derivation) {
  const std::size_t n = derivation.size();
  RealVector result(2 * n * n, 0);
  for (std::size_t i = 0; i < n; ++i) result[i * 2 * n + n + i] = 1;
  for (const RotationPlace& rotation : derivation.symbols.rotations) {
    add_rotation_block(derivation.symbols, rotation, result);
  }
  return result;
}

}  // namespace

ForwardDynamics forward_dynamics(Derivation& derivation) {
  AccelerationSolver dynamics(derivation);
  const ConstrainedSolver::Solution motion = dynamics.solve_motion();
  return {motion.x, dynamics.solver().relative_pivots(), motion.y, dynamics.solver().diagonal()};
}

std::optional<ArticulatedDynamics> articulated_dynamics(Derivation& derivation, bool has_pivots) {
  const Lagrangian& lagrangian = derivation.lagrangian;
  const bool is_tree = lagrangian.masses.empty() && lagrangian.lagrangian.empty() &&
                       lagrangian.constraints.empty() && !lagrangian.tree.bodies.empty();
  if (!is_tree || !lagrangian.is_quadratic || !lagrangian.eliminates_last_first)
    return std::nullopt;
  const std::optional<RealVector> armatures = energy_mass_diagonal(derivation);
  if (!armatures) return std::nullopt;
  KinematicTree& tree = tree_of(derivation);
  const auto joints = tree_joints(tree);
  if (!joints) return std::nullopt;
  const RealVector forces =
      negate(bias(derivation, InputForces::acting, BodySelection::outside_frames));
  const ArticulatedMotion motion =
      articulated_motion(tree, *joints, forces, *armatures, has_pivots);
  name_accelerations(derivation, motion.acceleration);
  RealVector relative_pivots;
  for (std::size_t i = 0; i < motion.diagonal.size(); ++i) {
    relative_pivots.push_back(motion.pivots[i] / motion.diagonal[i]);
  }
  return ArticulatedDynamics{{motion.acceleration, relative_pivots, {}, motion.diagonal},
                             count_factorisation_operations(tree, *joints)};
}

RealVector values_along_motion(Derivation& derivation, const RealVector& values) {
  Substitution at_solution =
      motion_substitution(derivation, AccelerationSolver(derivation).solve_motion());
  return define_and_substitute(at_solution, derivation.definitions, values);
}

InverseDerivatives inverse_dynamics_derivatives(Derivation& derivation) {
  return residual_derivatives(derivation, InputForces::absent);
}

ForwardDerivatives forward_dynamics_derivatives(Derivation& derivation) {
  AccelerationSolver dynamics(derivation);
  const ConstrainedSolver::Solution motion = dynamics.solve_motion();
  InverseDerivatives of_forces = residual_derivatives(derivation, InputForces::acting);
  InverseDerivatives of_constraints = constraint_derivatives(derivation);
  Substitution at_solution = motion_substitution(derivation, motion);
  for (InverseDerivatives* const derivatives : {&of_forces, &of_constraints}) {
    for (RealVector* const entries : {&derivatives->by_position, &derivatives->by_velocity}) {
      for (ex& entry : *entries) entry = -at_solution(entry);
    }
  }
  const RealVector forces_of_inputs = input_matrix(derivation);
  const std::size_t n = derivation.size();
  const std::size_t inputs = derivation.symbols.u.size();
  const RealVector at_rest(derivation.lagrangian.constraints.size() * inputs, 0);
  ForwardDerivatives result;
  result.by_position = dynamics.solve_columns(of_forces.by_position, of_constraints.by_position, n);
  result.by_velocity = dynamics.solve_columns(of_forces.by_velocity, of_constraints.by_velocity, n);
  result.by_input = dynamics.solve_columns(forces_of_inputs, at_rest, inputs);
  return result;
}

std::optional<ForwardDynamicsTerms> forward_dynamics_terms(Derivation& derivation) {
  const std::size_t n = derivation.size();
  if (n < min_composed_velocities || !derivation.lagrangian.constraints.empty())
    return std::nullopt;
  ForwardDynamicsTerms parts;
  parts.mass = mass_matrix(derivation);
  for (std::size_t i = 0; i < n; ++i) {
    if (parts.mass[i * n + i].is_zero()) throw ZeroPivot(RowKind::velocities, i, true);
  }
  parts.force = negate(bias(derivation, InputForces::acting));
  const InverseDerivatives rest = residual_derivatives(derivation, InputForces::acting);
  parts.forces = {negate(rest.by_position), negate(rest.by_velocity), input_matrix(derivation)};
  parts.rates = upper_linearization_rows(derivation);
  return parts;
}

RealVector input_force_derivatives(Derivation& derivation) {
  const std::size_t inputs = derivation.symbols.u.size();
  const RealVector b = input_matrix(derivation);
  RealVector force(derivation.size(), 0);
  for (std::size_t k = 0; k < b.size(); ++k) {
    force[k / inputs] += b[k] * derivation.symbols.u[k % inputs];
  }
  for (ex& entry : force) entry = define(derivation.definitions, entry);
  return directional_derivatives(derivation, force,
                                 [&](std::size_t j) { return derivation.displacement_tangent(j); });
}

RealVector inverse_mass_matrix(Derivation& derivation) {
  const std::size_t n = derivation.size();
  const RealVector mass = mass_matrix(derivation);
  SymmetricSolver solve(derivation.definitions, mass, velocity_elimination_order(derivation),
                        RowKind::velocities);
  RealVector entries(n * n);
  for (std::size_t j = 0; j < n; ++j) {
    const RealVector column = solve.solve(unit_vector(n, j));
    for (std::size_t i = j; i < n; ++i) entries[i * n + j] = entries[j * n + i] = column[i];
  }
  return entries;
}

OperationalDynamics operational_dynamics(Derivation& derivation, const RealVector& jacobian,
                                         const RealVector& bias_of_task) {
  const std::size_t n = derivation.size();
  const std::size_t k = bias_of_task.size();
  const RealVector mass = mass_matrix(derivation);
  ConstrainedSolver solve(derivation, mass, jacobian);
  OperationalDynamics result{RealVector(k * k), RealVector(n * k), {}, {}};
  for (std::size_t j = 0; j < k; ++j) {
    const ConstrainedSolver::Solution column = solve.solve(RealVector(n, 0), unit_vector(k, j));
    for (std::size_t i = j; i < k; ++i) {
      result.inertia[i * k + j] = result.inertia[j * k + i] = column.y[i];
    }
    for (std::size_t i = 0; i < n; ++i) result.inverse_jacobian[i * k + j] = column.x[i];
  }
  const RealVector force = negate(bias(derivation));
  result.bias = solve.solve(force, negate(bias_of_task)).y;
  result.relative_pivots = solve.relative_pivots_of_constraints();
  return result;
}

Linearization linearization(Derivation& derivation) {
  const ForwardDerivatives of_acceleration = forward_dynamics_derivatives(derivation);
  const std::size_t n = derivation.size();
  const std::size_t inputs = derivation.symbols.u.size();
  Linearization result;
  result.a = upper_linearization_rows(derivation);
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
