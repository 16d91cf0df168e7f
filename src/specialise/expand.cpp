// expand: energies and forces become polynomials in the deviations of what is small.
//
//     before    bob at (l*sin(q), -l*cos(q)) of mass m, gravity (0, -g)        q near 0, order 1
//     after     T = 1/2*m*l^2*v^2,  V = -m*g*l + 1/2*m*g*l*q^2
//
// Equations of order k need T - V and D to order k + 1, counting deviations and rates jointly, and
// forces to order k: one derivative is still to be taken of the energies. Those of coordinates that
// are not small lose no order by that derivative: right to order k + 1, with forces to that order.
// Masses, points and their forces have then become terms of T, V and the generalized forces.
#include <algorithm>

#include "formulate/chain_rule.hpp"
#include "specialise/passes.hpp"
#include "specialise/taylor_series.hpp"

namespace elgen {

using GiNaC::ex;

namespace {

/// 1/2 m |dp/dt|^2 and -m gravity.p
void add_masses(Lagrangian& lagrangian, Tangent& velocity) {
  for (const PointMass& mass : lagrangian.masses) {
    GiNaC::exvector squares;
    GiNaC::exvector heights;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const ex& at = mass.position[axis];
      const ex rate = define(lagrangian.definitions, velocity(at));
      squares.push_back(rate * rate);
      if (lagrangian.gravity) heights.push_back((*lagrangian.gravity)[axis] * at);
    }
    lagrangian.kinetic.push_back(mass.mass * GiNaC::add(squares) / 2);
    if (lagrangian.gravity) lagrangian.potential.push_back(-mass.mass * GiNaC::add(heights));
  }
  lagrangian.masses.clear();
  lagrangian.gravity.reset();
}

/// F.d(dp/dt)/dv, since rates of positions are linear in v.
void add_point_forces(Lagrangian& lagrangian, Tangent& velocity) {
  std::vector<Weighted> work;
  for (const PointForce& applied : lagrangian.point_forces) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      work.push_back({velocity(applied.position[axis]), applied.force[axis]});
    }
  }
  const std::vector<ex> forces = gradient(lagrangian.definitions, work, lagrangian.symbols.v);
  for (std::size_t i = 0; i < forces.size(); ++i) lagrangian.forces[i] += forces[i];
  lagrangian.point_forces.clear();
}

bool is_small(const Expansion& expansion, const ex& leaf) {
  return std::any_of(expansion.small.begin(), expansion.small.end(),
                     [&](const SmallLeaf& small) { return small.leaf.is_equal(leaf); });
}

}  // namespace

Lagrangian expanded(Lagrangian lagrangian) {
  const Expansion expansion = *lagrangian.expansion;
  // Positions hold no rates, so of the motion only dq/dt and t take part.
  Tangent velocity(lagrangian.definitions, motion_seeds(lagrangian.symbols), "_dot");
  add_masses(lagrangian, velocity);
  add_point_forces(lagrangian, velocity);
  TaylorSeries one_more(lagrangian.definitions, expansion.small, expansion.order + 1);
  for (auto* terms : {&lagrangian.kinetic, &lagrangian.potential, &lagrangian.dissipation,
                      &lagrangian.lagrangian}) {
    for (ex& term : *terms) term = one_more(term);
  }
  TaylorSeries of_small(lagrangian.definitions, expansion.small, expansion.order);
  for (std::size_t i = 0; i < lagrangian.forces.size(); ++i) {
    ex& force = lagrangian.forces[i];
    force = is_small(expansion, lagrangian.symbols.v[i]) ? of_small(force) : one_more(force);
  }
  return lagrangian;
}

}  // namespace elgen
