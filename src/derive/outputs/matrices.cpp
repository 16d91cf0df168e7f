// Matrices: a vector is derived once, then differentiated by a forward pass per unit direction.
#include "derive/lagrangian/turning.hpp"
#include "derive/outputs/outputs.hpp"
#include "derive/tree/tree_matrices.hpp"

namespace elgen {

using GiNaC::ex;

namespace {

bool has_columns(Derivation& derivation) { return tree_variables(tree_of(derivation)).is_complete; }

/// M, or its part without the bodies in frames.
Vector mass_matrix_of(Derivation& derivation, Bodies bodies) {
  const std::size_t n = derivation.size();
  const Vector other = derivation.by_velocity(derivation.lagrangian.quadratic
                                                  ? weighted(derivation.graded().kinetic2, 1)
                                                  : derivation.other_lagrangian());
  const Vector of_frames =
      bodies == Bodies::without_frames ? Vector(n) : momentum_of_frames(derivation);
  Vector entries(n * n);
  for (std::size_t j = 0; j < n; ++j) {
    Tangent position = derivation.displacement(j);
    Tangent velocity = derivation.unit_velocity(j);
    const Vector column = derivation.by_position(
        derivation.weighted_positions([&](const PointMass& mass, std::size_t axis) {
          const ex direction = define(derivation.definitions, position(mass.position[axis]));
          return define(derivation.definitions, mass.mass * direction);
        }));
    for (std::size_t i = j; i < n; ++i) {
      const ex of_energy = velocity(other[i]);
      entries[i * n + j] = entries[j * n + i] = column[i] + of_energy + velocity(of_frames[i]);
    }
  }
  return entries;
}

}  // namespace

Vector mass_matrix(Derivation& derivation) {
  if (!has_columns(derivation)) return mass_matrix_of(derivation, Bodies::all);
  Vector entries = mass_matrix_of(derivation, Bodies::without_frames);
  add_to_dense(tree_mass_matrix(tree_of(derivation)), entries, derivation.size());
  return entries;
}

Vector coriolis_matrix(Derivation& derivation) {
  const std::size_t n = derivation.size();
  const bool by_columns = has_columns(derivation);
  const Bodies bodies = by_columns ? Bodies::without_frames : Bodies::all;
  Vector force = velocity_force(derivation, bodies);
  for (ex& entry : force) entry = define(derivation.definitions, entry);
  Vector entries(n * n);
  for (std::size_t j = 0; j < n; ++j) {
    Tangent velocity = derivation.unit_velocity(j);
    for (std::size_t i = 0; i < n; ++i) entries[i * n + j] = velocity(force[i]) / 2;
  }
  if (!derivation.symbols.rotations.empty()) {
    const Vector mass = mass_matrix_of(derivation, bodies);
    add_turning(derivation, mass, entries);
  }
  if (by_columns) add_to_dense(tree_coriolis_matrix(tree_of(derivation)), entries, n);
  return entries;
}

Vector input_matrix(Derivation& derivation) {
  const std::size_t n = derivation.size();
  const std::size_t inputs = derivation.symbols.u.size();
  Vector entries(n * inputs);
  for (std::size_t j = 0; j < inputs; ++j) {
    Tangent input(derivation.definitions, Seeds{{derivation.symbols.u[j], 1}});
    TreeForces forces;
    for (const PointForce& applied : derivation.lagrangian.point_forces) {
      for (std::size_t axis = 0; axis < 3; ++axis) {
        forces.on_variables.push_back({applied.position[axis], input(applied.force[axis])});
      }
    }
    append(forces, tree_of(derivation).wrench_forces(std::ref(input)));
    const Vector column = by_velocities(derivation, forces);
    for (std::size_t i = 0; i < n; ++i) {
      entries[i * inputs + j] = column[i] + input(derivation.lagrangian.forces[i]);
    }
  }
  return entries;
}

namespace {

/// The twist (angular velocity; velocity of the origin) of the frame of `output`, 0 for the world.
Vector twist_of(Derivation& derivation, const TwistOutput& output) {
  if (!output.transform) return Vector(6, 0);
  Tree& tree = tree_of(derivation);
  const Twist twist = tree_twists(tree, derivation.zero_acceleration)[*output.transform];
  const auto axes = output.in_world ? std::optional<std::uint32_t>() : output.transform;
  const ExVector3 spin = tree.turned(twist.spin, output.transform, axes);
  const ExVector3 velocity = tree.turned(twist.velocity, output.transform, axes);
  Vector result(spin.begin(), spin.end());
  result.insert(result.end(), velocity.begin(), velocity.end());
  return result;
}

}  // namespace

Vector twist_jacobian(Derivation& derivation, const TwistOutput& output) {
  Vector entries;
  for (const ex& rate : twist_of(derivation, output)) {
    const Vector row = gradient(derivation.definitions, {{rate, 1}}, derivation.symbols.v);
    entries.insert(entries.end(), row.begin(), row.end());
  }
  return entries;
}

Vector twist_bias(Derivation& derivation, const TwistOutput& output) {
  Vector entries;
  for (const ex& rate : twist_of(derivation, output)) {
    entries.push_back(derivation.zero_acceleration(rate));
  }
  return entries;
}

Vector jacobian(Derivation& derivation, const Terms& values) {
  Vector entries;
  for (const ex& value : values) {
    const Vector row = derivation.by_position({{value, 1}});
    entries.insert(entries.end(), row.begin(), row.end());
  }
  return entries;
}

OutputDerivatives output_derivatives(Derivation& derivation, const Terms& values) {
  OutputDerivatives result;
  result.by_position = jacobian(derivation, values);
  const auto by = [&](const Vector& leaves, Vector& entries) {
    for (const ex& value : values) {
      const Vector row = gradient(derivation.definitions, {{value, 1}}, leaves);
      entries.insert(entries.end(), row.begin(), row.end());
    }
  };
  by(derivation.symbols.v, result.by_velocity);
  by(derivation.symbols.a, result.by_acceleration);
  by(derivation.symbols.u, result.by_input);
  return result;
}

Vector second_rate(Derivation& derivation, const Terms& values) {
  Vector entries;
  for (const ex& value : values) {
    const ex rate = define(derivation.definitions, derivation.zero_acceleration(value));
    entries.push_back(derivation.zero_acceleration(rate));
  }
  return entries;
}

}  // namespace elgen
