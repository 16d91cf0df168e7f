// Matrices: a vector is derived once, then differentiated by a forward pass per unit direction.
#include "derive/lagrangian/turning.hpp"
#include "derive/outputs/outputs.hpp"
#include "derive/tree/tree_matrices.hpp"

namespace elgen {

using GiNaC::ex;

namespace {

bool has_complete_variables(Derivation& derivation) {
  return tree_variables(tree_of(derivation)).is_complete;
}

/// M, or its part without the bodies in frames.
RealVector mass_matrix_of(Derivation& derivation, BodySelection bodies) {
  const std::size_t n = derivation.size();
  const RealVector other = derivation.gradient_by_velocity(
      derivation.lagrangian.is_quadratic ? weighted_terms(derivation.graded_energies().kinetic2, 1)
                                         : derivation.lagrangian_without_bodies());
  const RealVector of_frames =
      bodies == BodySelection::outside_frames ? RealVector(n) : momentum_of_frames(derivation);
  RealVector entries(n * n);
  for (std::size_t j = 0; j < n; ++j) {
    Tangent position = derivation.displacement_tangent(j);
    Tangent velocity = derivation.velocity_tangent(j);
    const RealVector column = derivation.gradient_by_position(
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

RealVector mass_matrix(Derivation& derivation) {
  if (!has_complete_variables(derivation)) return mass_matrix_of(derivation, BodySelection::all);
  RealVector entries = mass_matrix_of(derivation, BodySelection::outside_frames);
  add_to_dense(tree_mass_matrix(tree_of(derivation)), entries, derivation.size());
  return entries;
}

RealVector coriolis_matrix(Derivation& derivation) {
  const std::size_t n = derivation.size();
  const bool by_columns = has_complete_variables(derivation);
  const BodySelection bodies = by_columns ? BodySelection::outside_frames : BodySelection::all;
  RealVector force = velocity_force(derivation, bodies);
  for (ex& entry : force) entry = define(derivation.definitions, entry);
  RealVector entries(n * n);
  for (std::size_t j = 0; j < n; ++j) {
    Tangent velocity = derivation.velocity_tangent(j);
    for (std::size_t i = 0; i < n; ++i) entries[i * n + j] = velocity(force[i]) / 2;
  }
  if (!derivation.symbols.rotations.empty()) {
    const RealVector mass = mass_matrix_of(derivation, bodies);
    add_rotation_terms(derivation, mass, entries);
  }
  if (by_columns) add_to_dense(tree_coriolis_matrix(tree_of(derivation)), entries, n);
  return entries;
}

RealVector input_matrix(Derivation& derivation) {
  const std::size_t n = derivation.size();
  const std::size_t inputs = derivation.symbols.u.size();
  RealVector entries(n * inputs);
  for (std::size_t j = 0; j < inputs; ++j) {
    Tangent input(derivation.definitions, Seeds{{derivation.symbols.u[j], 1}});
    TreeForces forces;
    for (const PointForce& applied : derivation.lagrangian.point_forces) {
      for (std::size_t axis = 0; axis < 3; ++axis) {
        forces.on_variables.push_back({applied.position[axis], input(applied.force[axis])});
      }
    }
    append(forces, tree_of(derivation).wrench_forces(std::ref(input)));
    const RealVector column = generalised_forces(derivation, forces);
    for (std::size_t i = 0; i < n; ++i) {
      entries[i * inputs + j] = column[i] + input(derivation.lagrangian.forces[i]);
    }
  }
  return entries;
}

namespace {

/// The twist (angular velocity; velocity of the origin) of the frame of `output`, 0 for the world.
RealVector frame_twist(Derivation& derivation, const TwistOutput& output) {
  if (!output.transform) return RealVector(6, 0);
  KinematicTree& tree = tree_of(derivation);
  const Twist twist = tree_twists(tree, derivation.rate_without_acceleration)[*output.transform];
  const auto axes = output.is_in_world ? std::optional<std::uint32_t>() : output.transform;
  const ExVector3 spin = tree.change_axes(twist.spin, output.transform, axes);
  const ExVector3 velocity = tree.change_axes(twist.velocity, output.transform, axes);
  RealVector result(spin.begin(), spin.end());
  result.insert(result.end(), velocity.begin(), velocity.end());
  return result;
}

}  // namespace

RealVector twist_jacobian(Derivation& derivation, const TwistOutput& output) {
  RealVector entries;
  for (const ex& rate : frame_twist(derivation, output)) {
    const RealVector row = gradient(derivation.definitions, {{rate, 1}}, derivation.symbols.v);
    entries.insert(entries.end(), row.begin(), row.end());
  }
  return entries;
}

RealVector twist_bias(Derivation& derivation, const TwistOutput& output) {
  RealVector entries;
  for (const ex& rate : frame_twist(derivation, output)) {
    entries.push_back(derivation.rate_without_acceleration(rate));
  }
  return entries;
}

RealVector jacobian(Derivation& derivation, const Terms& values) {
  RealVector entries;
  for (const ex& value : values) {
    const RealVector row = derivation.gradient_by_position({{value, 1}});
    entries.insert(entries.end(), row.begin(), row.end());
  }
  return entries;
}

OutputDerivatives output_derivatives(Derivation& derivation, const Terms& values) {
  OutputDerivatives result;
  result.by_position = jacobian(derivation, values);
  const auto by = [&](const RealVector& leaves, RealVector& entries) {
    for (const ex& value : values) {
      const RealVector row = gradient(derivation.definitions, {{value, 1}}, leaves);
      entries.insert(entries.end(), row.begin(), row.end());
    }
  };
  by(derivation.symbols.v, result.by_velocity);
  by(derivation.symbols.a, result.by_acceleration);
  by(derivation.symbols.u, result.by_input);
  return result;
}

RealVector second_rate(Derivation& derivation, const Terms& values) {
  RealVector entries;
  for (const ex& value : values) {
    const ex rate = define(derivation.definitions, derivation.rate_without_acceleration(value));
    entries.push_back(derivation.rate_without_acceleration(rate));
  }
  return entries;
}

}  // namespace elgen
