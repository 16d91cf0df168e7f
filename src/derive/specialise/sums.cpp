// write_energy_sums: rewrites point masses, gravity and point forces as terms of T, V and Q.
//
//     before    mass m at p, gravity g, force F at p
//     after     T = 1/2 m |dp/dt|^2,  V = -m g.p,  Q = F.d(dp/dt)/dv
#include "derive/specialise/passes.hpp"

namespace elgen {

using GiNaC::ex;

namespace {

/// Adds 1/2 m |dp/dt|^2 to T and -m gravity.p to V.
void add_mass_energies(Lagrangian& lagrangian, Tangent& velocity) {
  for (const PointMass& mass : lagrangian.masses) {
    GiNaC::exvector squares;
    GiNaC::exvector heights;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const ex& at = mass.position[axis];
      const ex rate = define(lagrangian.definitions, velocity(at));
      squares.push_back(rate * rate);
      if (lagrangian.gravity) heights.push_back((*lagrangian.gravity)[axis] * at);
    }
    lagrangian.kinetic.push_back({mass.mass * GiNaC::add(squares) / 2, EnergyOrigin::mass});
    if (!lagrangian.gravity) continue;
    lagrangian.potential.push_back({-mass.mass * GiNaC::add(heights), EnergyOrigin::mass});
  }
  lagrangian.masses.clear();
  lagrangian.gravity.reset();
}

/// Adds F.d(dp/dt)/dv to Q; dp/dt is affine in v.
void add_point_forces(Lagrangian& lagrangian, Tangent& velocity) {
  std::vector<WeightedTerm> work;
  for (const PointForce& applied : lagrangian.point_forces) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      work.push_back({velocity(applied.position[axis]), applied.force[axis]});
    }
  }
  const std::vector<ex> forces = gradient(lagrangian.definitions, work, lagrangian.symbols.v);
  for (std::size_t i = 0; i < forces.size(); ++i) lagrangian.forces[i] += forces[i];
  lagrangian.point_forces.clear();
}

}  // namespace

void write_energy_sums(Lagrangian& lagrangian) {
  // Positions do not depend on v, so the seeds v -> a have no effect.
  Tangent velocity(lagrangian.definitions, motion_seeds(lagrangian.symbols), "_dot");
  add_mass_energies(lagrangian, velocity);
  add_point_forces(lagrangian, velocity);
}

}  // namespace elgen
