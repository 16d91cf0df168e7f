// Energies, term by term over the definitions.
#include "derive/outputs/outputs.hpp"
#include "derive/tree/tree_dynamics.hpp"

namespace elgen {

using GiNaC::ex;

namespace {

void append_terms(GiNaC::exvector& to, const Terms& from, int sign) {
  for (const ex& term : from) to.push_back(sign * term);
}

/// Appends sign * T of the point masses and of the bodies in frames. Velocities are dp/ds along the
/// direction `along`.
void append_kinetic_energy(GiNaC::exvector& terms, Derivation& derivation, Tangent& along,
                           int sign) {
  for (const PointMass& mass : derivation.lagrangian.masses) {
    GiNaC::exvector squares;
    for (const ex& component : mass.position) {
      const ex velocity = define(derivation.definitions, along(component));
      squares.push_back(velocity * velocity);
    }
    terms.push_back(GiNaC::numeric(sign, 2) * mass.mass * GiNaC::add(squares));
  }
  KinematicTree& tree = tree_of(derivation);
  append_terms(terms, tree_kinetic_energy(tree, along), sign);
}

/// Appends V = -sum m gravity.p of the point masses and of the bodies in frames.
void append_gravity_energy(GiNaC::exvector& terms, Derivation& derivation) {
  const Lagrangian& lagrangian = derivation.lagrangian;
  if (!lagrangian.gravity) return;
  KinematicTree& tree = tree_of(derivation);
  append_terms(terms, tree_potential_energy(tree), 1);
  for (const PointMass& mass : lagrangian.masses) {
    GiNaC::exvector heights;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      heights.push_back((*lagrangian.gravity)[axis] * mass.position[axis]);
    }
    terms.push_back(-mass.mass * GiNaC::add(heights));
  }
}

GiNaC::exvector kinetic_terms(Derivation& derivation) {
  GiNaC::exvector terms;
  append_kinetic_energy(terms, derivation, derivation.rate_without_acceleration, 1);
  const bool whole = !derivation.lagrangian.lagrangian.empty();
  append_terms(
      terms,
      whole ? derivation.graded_energies().kinetic2 : values_of(derivation.lagrangian.kinetic), 1);
  return terms;
}

}  // namespace

ex kinetic_energy_of_masses(Derivation& derivation) {
  GiNaC::exvector terms;
  append_kinetic_energy(terms, derivation, derivation.rate_without_acceleration, 1);
  return GiNaC::add(terms);
}

ex potential_energy_of_masses(Derivation& derivation) {
  GiNaC::exvector terms;
  append_gravity_energy(terms, derivation);
  return GiNaC::add(terms);
}

ex kinetic_energy(Derivation& derivation) { return GiNaC::add(kinetic_terms(derivation)); }

ex potential_energy(Derivation& derivation) {
  GiNaC::exvector terms;
  append_gravity_energy(terms, derivation);
  append_terms(terms, derivation.graded_energies().potential0, 1);
  return GiNaC::add(terms);
}

ex total_energy(Derivation& derivation) {
  GiNaC::exvector terms = kinetic_terms(derivation);
  append_gravity_energy(terms, derivation);
  append_terms(terms, derivation.graded_energies().potential0, 1);
  append_terms(terms, derivation.graded_energies().potential1, 1);
  return GiNaC::add(terms);
}

ex energy_at_rest(Derivation& derivation) {
  GiNaC::exvector terms;
  append_kinetic_energy(terms, derivation, derivation.time_partial, -1);
  append_terms(terms, derivation.graded_energies().kinetic0, -1);
  append_gravity_energy(terms, derivation);
  append_terms(terms, derivation.graded_energies().potential0, 1);
  return GiNaC::add(terms);
}

ex energy_function(Derivation& derivation) {
  GiNaC::exvector terms;
  if (!derivation.lagrangian.is_quadratic) {
    const RealVector momentum =
        derivation.gradient_by_velocity(derivation.lagrangian_without_bodies());
    for (std::size_t i = 0; i < momentum.size(); ++i) {
      terms.push_back(derivation.symbols.v[i] * momentum[i]);
    }
    append_terms(terms, values_of(derivation.lagrangian.lagrangian), -1);
    return GiNaC::add(terms);
  }
  append_kinetic_energy(terms, derivation, derivation.rate_at_fixed_time, 1);
  terms.push_back(energy_at_rest(derivation));
  append_terms(terms, derivation.graded_energies().kinetic2, 1);
  return GiNaC::add(terms);
}

}  // namespace elgen
