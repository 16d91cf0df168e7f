// Generalised forces. Each takes one reverse pass over positions and energies, and forward passes
// for the rates of momenta.
#include "derive/lagrangian/turning.hpp"
#include "derive/outputs/outputs.hpp"
#include "derive/tree/tree_dynamics.hpp"

namespace elgen {

using GiNaC::ex;

namespace {

/// The derivative of each entry along a direction.
Vector rates(const Vector& values, Tangent& along) {
  Vector result;
  for (const ex& value : values) result.push_back(along(value));
  return result;
}

/// The rate of `momentum` = dL/dv along a motion, plus Hamel's term [w]x dL/dw for angular
/// velocities w.
Vector momentum_rates(Derivation& derivation, const Vector& momentum, Tangent& along) {
  Vector result = rates(momentum, along);
  const Vector turning = hamel_force(derivation, momentum);
  return plus(std::move(result), turning);
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
std::vector<Weighted> inertial_forces_of_masses(Derivation& derivation, Tangent& second) {
  const std::array<ex, 3> g = gravity_vector(derivation);
  return derivation.weighted_positions([&](const PointMass& mass, std::size_t axis) {
    const ex velocity =
        define(derivation.definitions, derivation.zero_acceleration(mass.position[axis]));
    const ex acceleration = second(velocity);
    const ex force = mass.mass * (acceleration - g[axis]);
    return define(derivation.definitions, force, {force_name(mass, derivation, axis), mass.origin});
  });
}

/// The substitution u = 0 if the inputs are absent; else an empty substitution.
Substitution acting(Derivation& derivation, InputForces inputs) {
  Seeds values;
  if (inputs == InputForces::absent) {
    for (const ex& input : derivation.symbols.u) values.emplace(input, 0);
  }
  return {derivation.definitions, values};
}

/// -F of each point force, as part of the left-hand side M a + bias.
std::vector<Weighted> negative_point_forces(Derivation& derivation, InputForces inputs) {
  std::vector<Weighted> result;
  Substitution force = acting(derivation, inputs);
  for (const PointForce& applied : derivation.lagrangian.point_forces) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      result.push_back({applied.position[axis], -force(applied.force[axis])});
    }
  }
  return result;
}

Vector direct_forces(Derivation& derivation, InputForces inputs) {
  Substitution force = acting(derivation, inputs);
  Vector result = derivation.lagrangian.forces;
  for (ex& entry : result) entry = force(entry);
  return result;
}

TreeForces opposite(TreeForces forces) {
  for (Weighted& term : forces.on_variables) term.weight = -term.weight;
  for (auto& [velocity, force] : forces.on_velocities) force = -force;
  return forces;
}

TreeForces negative_wrenches(Derivation& derivation, InputForces inputs) {
  Substitution force = acting(derivation, inputs);
  return opposite(tree_of(derivation).wrench_forces(std::ref(force)));
}

/// Inertial forces minus weights of bodies in frames: the base has the acceleration -gravity.
TreeForces tree_forces(Derivation& derivation, Tangent& second) {
  return inertial_forces(tree_of(derivation), {derivation.zero_acceleration, second, true});
}

/// M a + bias - B u; without B u if the inputs are absent. `second` differentiates velocities: with
/// `zero_acceleration`, a is 0.
Vector left_side(Derivation& derivation, Tangent& second, InputForces inputs, Bodies bodies) {
  TreeForces forces{inertial_forces_of_masses(derivation, second)};
  append(forces.on_variables, negative_point_forces(derivation, inputs));
  if (bodies == Bodies::all) append(forces, tree_forces(derivation, second));
  append(forces, negative_wrenches(derivation, inputs));
  for (const Weighted& term : derivation.other_lagrangian()) {
    forces.on_variables.push_back({term.value, -term.weight});
  }
  Vector result = by_velocities(derivation, forces);
  const Vector momentum = derivation.by_velocity(derivation.other_lagrangian());
  result = plus(result, momentum_rates(derivation, momentum, second));
  result = plus(result, dissipation(derivation));
  const Vector direct = direct_forces(derivation, inputs);
  for (std::size_t i = 0; i < result.size(); ++i) result[i] -= direct[i];
  return result;
}

}  // namespace

Vector inverse_dynamics(Derivation& derivation) {
  return left_side(derivation, derivation.motion, InputForces::absent, Bodies::all);
}

Vector residual(Derivation& derivation, InputForces inputs, Bodies bodies) {
  return left_side(derivation, derivation.motion, inputs, bodies);
}

Vector bias(Derivation& derivation, InputForces inputs, Bodies bodies) {
  return left_side(derivation, derivation.zero_acceleration, inputs, bodies);
}

Vector velocity_force(Derivation& derivation, Bodies bodies) {
  Definitions& definitions = derivation.definitions;
  TreeForces forces{derivation.weighted_positions([&](const PointMass& mass, std::size_t axis) {
    const ex velocity = define(definitions, derivation.fixed_time(mass.position[axis]));
    return define(definitions, mass.mass * derivation.fixed_time(velocity));
  })};
  const Terms& kinetic = derivation.graded().kinetic2;
  append(forces.on_variables, weighted(kinetic, -1));
  if (bodies == Bodies::all) {
    append(forces,
           inertial_forces(tree_of(derivation), {derivation.fixed_time, derivation.fixed_time}));
  }
  const Vector momentum = derivation.by_velocity(weighted(kinetic, 1));
  Vector result = by_velocities(derivation, forces);
  return plus(result, momentum_rates(derivation, momentum, derivation.fixed_time));
}

Vector drift(Derivation& derivation) {
  Definitions& definitions = derivation.definitions;
  // p'' at a = 0, without its part quadratic in v: 2 (d2p/dq dt) dq/dt + d2p/dt2.
  TreeForces forces{derivation.weighted_positions([&](const PointMass& mass, std::size_t axis) {
    const ex passing = define(definitions, derivation.time_partial(mass.position[axis]));
    const ex at_rest = derivation.time_partial(passing);
    const ex acceleration = at_rest + 2 * derivation.fixed_time(passing);
    return define(definitions, mass.mass * acceleration);
  })};
  const GradedEnergies& energies = derivation.graded();
  std::vector<Weighted> linear = weighted(energies.kinetic1, 1);
  append(linear, weighted(energies.potential1, -1));
  for (const Weighted& term : linear) forces.on_variables.push_back({term.value, -term.weight});
  append(forces.on_variables, weighted(energies.kinetic0, -1));
  // For bodies in frames: all inertial forces at a = 0, minus the inertial forces at frozen time.
  Tree& tree = tree_of(derivation);
  append(forces,
         inertial_forces(tree, {derivation.zero_acceleration, derivation.zero_acceleration}));
  append(forces, opposite(inertial_forces(tree, {derivation.fixed_time, derivation.fixed_time})));
  Vector result = by_velocities(derivation, forces);
  const Vector momentum = derivation.by_velocity(linear);
  result = plus(result, momentum_rates(derivation, momentum, derivation.zero_acceleration));
  const Vector quadratic = derivation.by_velocity(weighted(energies.kinetic2, 1));
  return plus(result, rates(quadratic, derivation.time_partial));
}

Vector gravity(Derivation& derivation) {
  const std::array<ex, 3> g = gravity_vector(derivation);
  TreeForces forces{derivation.weighted_positions([&](const PointMass& mass, std::size_t axis) {
    return define(derivation.definitions, -mass.mass * g[axis]);
  })};
  append(forces.on_variables, weighted(derivation.graded().potential0, 1));
  append(forces, tree_gravity(tree_of(derivation)));
  return by_velocities(derivation, forces);
}

Vector dissipation(Derivation& derivation) {
  return gradient(derivation.definitions, weighted(derivation.lagrangian.dissipation, 1),
                  derivation.symbols.v);
}

Vector applied_force(Derivation& derivation, InputForces inputs) {
  TreeForces forces{negative_point_forces(derivation, inputs)};
  append(forces, negative_wrenches(derivation, inputs));
  Vector result = by_velocities(derivation, forces);
  const Vector direct = direct_forces(derivation, inputs);
  for (std::size_t i = 0; i < result.size(); ++i) result[i] = direct[i] - result[i];
  return result;
}

Vector momentum_of_frames(Derivation& derivation) {
  return by_velocities(derivation, tree_momentum(tree_of(derivation)));
}

Vector momentum(Derivation& derivation) {
  const std::vector<Weighted> of_masses =
      derivation.weighted_positions([&](const PointMass& mass, std::size_t axis) {
        const ex velocity =
            define(derivation.definitions, derivation.zero_acceleration(mass.position[axis]));
        return define(derivation.definitions, mass.mass * velocity);
      });
  Vector result = derivation.by_position(of_masses);
  result = plus(result, momentum_of_frames(derivation));
  return plus(result, derivation.by_velocity(derivation.other_lagrangian()));
}

Vector position_gradient(Derivation& derivation) {
  const std::array<ex, 3> g = gravity_vector(derivation);
  std::vector<Weighted> sum;
  for (const PointMass& mass : derivation.lagrangian.masses) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const ex velocity =
          define(derivation.definitions, derivation.zero_acceleration(mass.position[axis]));
      sum.push_back({velocity, define(derivation.definitions, mass.mass * velocity)});
      sum.push_back({mass.position[axis], define(derivation.definitions, mass.mass * g[axis])});
    }
  }
  Tree& tree = tree_of(derivation);
  append(sum, weighted(tree_kinetic_energy(tree, derivation.zero_acceleration), 1));
  append(sum, weighted(tree_potential_energy(tree), -1));
  append(sum, derivation.other_lagrangian());
  return derivation.by_position(sum);
}

Vector cyclic_rates(Derivation& derivation) { return derivation.lagrangian.cyclic_rates; }

/// The rows of the locked coordinates in the equations before locking, at the locked values.
///
///     before    row of q1: (I1 + I2 + ...)*q1_ddot + ... - tau1
///     after     the same with q1 = s(t), q1_dot = ds/dt, q1_ddot = d2s/dt2
Vector reaction(Derivation& derivation) {
  const ReactionSource& holding = *derivation.lagrangian.reaction_source;
  return derive_with_shared_definitions(derivation, *holding.whole, [&holding](Derivation& moving) {
    const Vector rows = residual(moving, InputForces::acting, Bodies::all);
    Substitution at_locked_values(moving.definitions, holding.values);
    Vector result;
    for (const std::uint32_t velocity : holding.velocities) {
      const ex row = define(moving.definitions, rows[velocity]);
      result.push_back(at_locked_values(row));
    }
    return result;
  });
}

}  // namespace elgen
