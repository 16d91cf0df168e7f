// Generalised forces. Each force needs one reverse pass over positions and energies, and forward
// passes for the rates of momenta.
#include "derive/lagrangian/turning.hpp"
#include "derive/outputs/outputs.hpp"
#include "derive/tree/tree_dynamics.hpp"

namespace elgen {

using GiNaC::ex;

namespace {

/// The derivative of each entry along a direction.
RealVector rates_along(const RealVector& values, Tangent& along) {
  RealVector result;
  for (const ex& value : values) result.push_back(along(value));
  return result;
}

/// The rate of `momentum` = dL/dv along a motion, plus Hamel's term [w]x dL/dw for angular
/// velocities w.
RealVector momentum_rates(Derivation& derivation, const RealVector& momentum, Tangent& along) {
  RealVector result = rates_along(momentum, along);
  const RealVector turning = hamel_force(derivation, momentum);
  return vector_sum(std::move(result), turning);
}

std::array<ex, 3> gravity_vector(const Derivation& derivation) {
  return derivation.lagrangian.gravity.value_or(std::array<ex, 3>{0, 0, 0});
}

std::string force_name(const PointMass& mass, const Derivation& derivation, std::size_t axis) {
  const SymbolPlace* place = nullptr;
  const auto found = derivation.definitions.places.find(mass.position[axis]);
  if (found != derivation.definitions.places.end()) place = &found->second;
  if (place == nullptr || !place->is_definition) return {};
  const std::string& name = derivation.definitions.list[place->index].name;
  return name.empty() ? std::string() : "force_" + name;
}

/// m (p'' - gravity) of each point mass. `second` differentiates the velocity dp/dt.
std::vector<WeightedTerm> inertial_forces_of_masses(Derivation& derivation, Tangent& second) {
  const std::array<ex, 3> g = gravity_vector(derivation);
  return derivation.weighted_positions([&](const PointMass& mass, std::size_t axis) {
    const ex velocity =
        define(derivation.definitions, derivation.rate_without_acceleration(mass.position[axis]));
    const ex acceleration = second(velocity);
    const ex force = mass.mass * (acceleration - g[axis]);
    return define(derivation.definitions, force, {force_name(mass, derivation, axis), mass.origin});
  });
}

/// The substitution u = 0 if the inputs are absent; else an empty substitution.
Substitution input_substitution(Derivation& derivation, InputForces inputs) {
  Seeds values;
  if (inputs == InputForces::absent) {
    for (const ex& input : derivation.symbols.u) values.emplace(input, 0);
  }
  return {derivation.definitions, values};
}

/// -F of each point force, as part of the left-hand side M a + bias.
std::vector<WeightedTerm> negative_point_forces(Derivation& derivation, InputForces inputs) {
  std::vector<WeightedTerm> result;
  Substitution force = input_substitution(derivation, inputs);
  for (const PointForce& applied : derivation.lagrangian.point_forces) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      result.push_back({applied.position[axis], -force(applied.force[axis])});
    }
  }
  return result;
}

RealVector direct_forces(Derivation& derivation, InputForces inputs) {
  Substitution force = input_substitution(derivation, inputs);
  RealVector result = derivation.lagrangian.forces;
  for (ex& entry : result) entry = force(entry);
  return result;
}

TreeForces negate_forces(TreeForces forces) {
  for (WeightedTerm& term : forces.on_variables) term.weight = -term.weight;
  for (auto& [velocity, force] : forces.on_velocities) force = -force;
  return forces;
}

TreeForces negative_wrench_forces(Derivation& derivation, InputForces inputs) {
  Substitution force = input_substitution(derivation, inputs);
  return negate_forces(tree_of(derivation).wrench_forces(std::ref(force)));
}

/// Inertial forces minus weights of bodies in frames: the base has the acceleration -gravity.
TreeForces tree_forces(Derivation& derivation, Tangent& second) {
  return inertial_forces(tree_of(derivation), {derivation.rate_without_acceleration, second, true});
}

/// M a + bias - B u; without B u if the inputs are absent. `second` differentiates velocities; a is
/// 0 if `second` is `rate_without_acceleration`.
RealVector left_side(Derivation& derivation, Tangent& second, InputForces inputs,
                     BodySelection bodies) {
  TreeForces forces{inertial_forces_of_masses(derivation, second)};
  append_terms(forces.on_variables, negative_point_forces(derivation, inputs));
  if (bodies == BodySelection::all) append(forces, tree_forces(derivation, second));
  append(forces, negative_wrench_forces(derivation, inputs));
  for (const WeightedTerm& term : derivation.lagrangian_without_bodies()) {
    forces.on_variables.push_back({term.value, -term.weight});
  }
  RealVector result = generalised_forces(derivation, forces);
  const RealVector momentum =
      derivation.gradient_by_velocity(derivation.lagrangian_without_bodies());
  result = vector_sum(result, momentum_rates(derivation, momentum, second));
  result = vector_sum(result, dissipation(derivation));
  const RealVector direct = direct_forces(derivation, inputs);
  for (std::size_t i = 0; i < result.size(); ++i) result[i] -= direct[i];
  return result;
}

}  // namespace

RealVector inverse_dynamics(Derivation& derivation) {
  return left_side(derivation, derivation.motion_rate, InputForces::absent, BodySelection::all);
}

RealVector dynamics_residual(Derivation& derivation, InputForces inputs, BodySelection bodies) {
  return left_side(derivation, derivation.motion_rate, inputs, bodies);
}

RealVector bias(Derivation& derivation, InputForces inputs, BodySelection bodies) {
  return left_side(derivation, derivation.rate_without_acceleration, inputs, bodies);
}

RealVector velocity_force(Derivation& derivation, BodySelection bodies) {
  Definitions& definitions = derivation.definitions;
  TreeForces forces{derivation.weighted_positions([&](const PointMass& mass, std::size_t axis) {
    const ex velocity = define(definitions, derivation.rate_at_fixed_time(mass.position[axis]));
    return define(definitions, mass.mass * derivation.rate_at_fixed_time(velocity));
  })};
  const Terms& kinetic = derivation.graded_energies().kinetic2;
  append_terms(forces.on_variables, weighted_terms(kinetic, -1));
  if (bodies == BodySelection::all) {
    append(forces, inertial_forces(tree_of(derivation),
                                   {derivation.rate_at_fixed_time, derivation.rate_at_fixed_time}));
  }
  const RealVector momentum = derivation.gradient_by_velocity(weighted_terms(kinetic, 1));
  RealVector result = generalised_forces(derivation, forces);
  return vector_sum(result, momentum_rates(derivation, momentum, derivation.rate_at_fixed_time));
}

RealVector drift(Derivation& derivation) {
  Definitions& definitions = derivation.definitions;
  // p'' at a = 0, without its part quadratic in v: 2 (d2p/dq dt) dq/dt + d2p/dt2.
  TreeForces forces{derivation.weighted_positions([&](const PointMass& mass, std::size_t axis) {
    const ex passing = define(definitions, derivation.time_partial(mass.position[axis]));
    const ex at_rest = derivation.time_partial(passing);
    const ex acceleration = at_rest + 2 * derivation.rate_at_fixed_time(passing);
    return define(definitions, mass.mass * acceleration);
  })};
  const GradedEnergies& energies = derivation.graded_energies();
  std::vector<WeightedTerm> linear = weighted_terms(energies.kinetic1, 1);
  append_terms(linear, weighted_terms(energies.potential1, -1));
  for (const WeightedTerm& term : linear) forces.on_variables.push_back({term.value, -term.weight});
  append_terms(forces.on_variables, weighted_terms(energies.kinetic0, -1));
  // For bodies in frames: all inertial forces at a = 0, minus the inertial forces at frozen time.
  KinematicTree& tree = tree_of(derivation);
  append(forces, inertial_forces(tree, {derivation.rate_without_acceleration,
                                        derivation.rate_without_acceleration}));
  append(forces, negate_forces(inertial_forces(
                     tree, {derivation.rate_at_fixed_time, derivation.rate_at_fixed_time})));
  RealVector result = generalised_forces(derivation, forces);
  const RealVector momentum = derivation.gradient_by_velocity(linear);
  result = vector_sum(result,
                      momentum_rates(derivation, momentum, derivation.rate_without_acceleration));
  const RealVector quadratic =
      derivation.gradient_by_velocity(weighted_terms(energies.kinetic2, 1));
  return vector_sum(result, rates_along(quadratic, derivation.time_partial));
}

RealVector gravity(Derivation& derivation) {
  const std::array<ex, 3> g = gravity_vector(derivation);
  TreeForces forces{derivation.weighted_positions([&](const PointMass& mass, std::size_t axis) {
    return define(derivation.definitions, -mass.mass * g[axis]);
  })};
  append_terms(forces.on_variables, weighted_terms(derivation.graded_energies().potential0, 1));
  append(forces, tree_gravity_forces(tree_of(derivation)));
  return generalised_forces(derivation, forces);
}

RealVector dissipation(Derivation& derivation) {
  return gradient(derivation.definitions, weighted_terms(derivation.lagrangian.dissipation, 1),
                  derivation.symbols.v);
}

RealVector applied_force(Derivation& derivation, InputForces inputs) {
  TreeForces forces{negative_point_forces(derivation, inputs)};
  append(forces, negative_wrench_forces(derivation, inputs));
  RealVector result = generalised_forces(derivation, forces);
  const RealVector direct = direct_forces(derivation, inputs);
  for (std::size_t i = 0; i < result.size(); ++i) result[i] = direct[i] - result[i];
  return result;
}

RealVector momentum_of_frames(Derivation& derivation) {
  return generalised_forces(derivation, tree_momentum(tree_of(derivation)));
}

RealVector momentum(Derivation& derivation) {
  const std::vector<WeightedTerm> of_masses =
      derivation.weighted_positions([&](const PointMass& mass, std::size_t axis) {
        const ex velocity = define(derivation.definitions,
                                   derivation.rate_without_acceleration(mass.position[axis]));
        return define(derivation.definitions, mass.mass * velocity);
      });
  RealVector result = derivation.gradient_by_position(of_masses);
  result = vector_sum(result, momentum_of_frames(derivation));
  return vector_sum(result,
                    derivation.gradient_by_velocity(derivation.lagrangian_without_bodies()));
}

RealVector position_gradient(Derivation& derivation) {
  const std::array<ex, 3> g = gravity_vector(derivation);
  std::vector<WeightedTerm> sum;
  for (const PointMass& mass : derivation.lagrangian.masses) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const ex velocity =
          define(derivation.definitions, derivation.rate_without_acceleration(mass.position[axis]));
      sum.push_back({velocity, define(derivation.definitions, mass.mass * velocity)});
      sum.push_back({mass.position[axis], define(derivation.definitions, mass.mass * g[axis])});
    }
  }
  KinematicTree& tree = tree_of(derivation);
  append_terms(sum,
               weighted_terms(tree_kinetic_energy(tree, derivation.rate_without_acceleration), 1));
  append_terms(sum, weighted_terms(tree_potential_energy(tree), -1));
  append_terms(sum, derivation.lagrangian_without_bodies());
  return derivation.gradient_by_position(sum);
}

RealVector cyclic_rates(Derivation& derivation) { return derivation.lagrangian.cyclic_rates; }

/// The rows of the locked coordinates in the equations before locking, at the locked values.
///
///     before    row of q1: (I1 + I2 + ...)*q1_ddot + ... - tau1
///     after     the same with q1 = s(t), q1_dot = ds/dt, q1_ddot = d2s/dt2
RealVector reaction(Derivation& derivation) {
  const ReactionSource& holding = *derivation.lagrangian.reaction_source;
  return derive_with_shared_definitions(
      derivation, *holding.unreduced, [&holding](Derivation& moving) {
        const RealVector rows = dynamics_residual(moving, InputForces::acting, BodySelection::all);
        Substitution at_locked_values(moving.definitions, holding.values);
        RealVector result;
        for (const std::uint32_t velocity : holding.velocities) {
          const ex row = define(moving.definitions, rows[velocity]);
          result.push_back(at_locked_values(row));
        }
        return result;
      });
}

}  // namespace elgen
