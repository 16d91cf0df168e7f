// expand: energies and forces become polynomials in the deviations of what is small.
//
//     before    bob at (l*sin(q), -l*cos(q)) of mass m, gravity (0, -g)        q near 0, order 1
//     after     T = 1/2*m*l^2*v^2,  V = -m*g*l + 1/2*m*g*l*q^2
//
// Equations of order k need T - V and D to order k + 1, counting deviations and rates jointly, and
// forces to order k: one derivative is still to be taken of the energies. Those of coordinates that
// are not small lose no order by that derivative: right to order k + 1, with forces to that order.
#include <algorithm>

#include "derive/specialise/passes.hpp"
#include "derive/specialise/taylor_series.hpp"

namespace elgen {

using GiNaC::ex;

namespace {

bool is_small(const Expansion& expansion, const ex& leaf) {
  return std::any_of(expansion.small.begin(), expansion.small.end(),
                     [&](const SmallLeaf& small) { return small.leaf.is_equal(leaf); });
}

}  // namespace

Lagrangian expanded(Lagrangian lagrangian) {
  const Expansion expansion = *lagrangian.expansion;
  write_sums(lagrangian);
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
