// Energies, term by term over the definitions.
#include "derive/outputs/outputs.hpp"
#include "derive/tree/tree_dynamics.hpp"

namespace elgen {

using GiNaC::ex;

namespace {

void append(GiNaC::exvector& to, const Terms& from, int sign) {
  for (const ex& term : from) to.push_back(sign * term);
}

/// Appends sign * T of the point masses and of the bodies in frames, with velocities dp/ds along a
/// direction.
void append_squares(GiNaC::exvector& terms, Derivation& derivation, Tangent& along, int sign) {
  for (const PointMass& mass : derivation.lagrangian.masses) {
    GiNaC::exvector squares;
    for (const ex& component : mass.position) {
      const ex velocity = define(derivation.definitions, along(component));
      squares.push_back(velocity * velocity);
    }
    terms.push_back(GiNaC::numeric(sign, 2) * mass.mass * GiNaC::add(squares));
  }
  Tree& tree = tree_of(derivation);
  append(terms, tree_kinetic_energy(tree, along), sign);
}

/// Appends V = -sum m gravity.p of the point masses and of the bodies in frames.
void append_weights(GiNaC::exvector& terms, Derivation& derivation) {
  const Lagrangian& lagrangian = derivation.lagrangian;
  if (!lagrangian.gravity) return;
  Tree& tree = tree_of(derivation);
  append(terms, tree_potential_energy(tree), 1);
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
  append_squares(terms, derivation, derivation.zero_acceleration, 1);
  const bool whole = !derivation.lagrangian.lagrangian.empty();
  append(terms, whole ? derivation.graded().kinetic2 : values_of(derivation.lagrangian.kinetic), 1);
  return terms;
}

}  // namespace

ex kinetic_energy_of_masses(Derivation& derivation) {
  GiNaC::exvector terms;
  append_squares(terms, derivation, derivation.zero_acceleration, 1);
  return GiNaC::add(terms);
}

ex weight_of_masses(Derivation& derivation) {
  GiNaC::exvector terms;
  append_weights(terms, derivation);
  return GiNaC::add(terms);
}

ex kinetic_energy(Derivation& derivation) { return GiNaC::add(kinetic_terms(derivation)); }

ex potential_energy(Derivation& derivation) {
  GiNaC::exvector terms;
  append_weights(terms, derivation);
  append(terms, derivation.graded().potential0, 1);
  return GiNaC::add(terms);
}

ex total_energy(Derivation& derivation) {
  GiNaC::exvector terms = kinetic_terms(derivation);
  append_weights(terms, derivation);
  append(terms, derivation.graded().potential0, 1);
  append(terms, derivation.graded().potential1, 1);
  return GiNaC::add(terms);
}

ex energy_at_rest(Derivation& derivation) {
  GiNaC::exvector terms;
  append_squares(terms, derivation, derivation.time_partial, -1);
  append(terms, derivation.graded().kinetic0, -1);
  append_weights(terms, derivation);
  append(terms, derivation.graded().potential0, 1);
  return GiNaC::add(terms);
}

ex energy_function(Derivation& derivation) {
  GiNaC::exvector terms;
  if (!derivation.lagrangian.quadratic) {
    const Vector momentum = derivation.by_velocity(derivation.other_lagrangian());
    for (std::size_t i = 0; i < momentum.size(); ++i) {
      terms.push_back(derivation.symbols.v[i] * momentum[i]);
    }
    append(terms, values_of(derivation.lagrangian.lagrangian), -1);
    return GiNaC::add(terms);
  }
  append_squares(terms, derivation, derivation.fixed_time, 1);
  terms.push_back(energy_at_rest(derivation));
  append(terms, derivation.graded().kinetic2, 1);
  return GiNaC::add(terms);
}

}  // namespace elgen
