// expand: replaces energies and forces by polynomials in the deviations of the small leaves.
//
//     before    bob at (l*sin(q), -l*cos(q)) of mass m, gravity (0, -g)        q near 0, order 1
//     after     T = 1/2*m*l^2*v^2,  V = -m*g*l + 1/2*m*g*l*q^2
//
// Equations of order k need forces to order k, and T - V and D to order k + 1, jointly in
// deviations and rates, because the equations contain first derivatives of the energies.
// Derivatives with respect to a coordinate that is not small, or to its rate, lose no order. The
// equation of this coordinate has order k + 1, so its force is expanded to order k + 1.
#include "derive/specialise/expand.hpp"

#include <algorithm>
#include <string>

#include "derive/formulate/chain_rule.hpp"
#include "derive/specialise/passes.hpp"

namespace elgen {

using GiNaC::ex;

namespace {

bool is_small(const Expansion& expansion, const ex& leaf) {
  return std::any_of(expansion.small.begin(), expansion.small.end(),
                     [&](const SmallLeaf& small) { return small.leaf.is_equal(leaf); });
}

}  // namespace

TaylorSeries::TaylorSeries(Definitions& definitions, const std::vector<SmallLeaf>& small,
                           unsigned order)
    : definitions_(definitions), order_(order) {
  for (const SmallLeaf& leaf : small) {
    Coefficients coefficients(order + 1, 0);
    coefficients[0] = leaf.value;
    coefficients[1] = leaf.leaf - leaf.value;
    coefficients_.emplace(leaf.leaf, std::move(coefficients));
    mask_ |= definitions.places.at(leaf.leaf).leaf_dependence;
  }
}

/// The coefficients of s^0, s^1, … in `term` after the substitution of x0 + s x1 + s^2 x2 + … for
/// each x.
TaylorSeries::Coefficients TaylorSeries::coefficients_of(const ex& term) const {
  GiNaC::exmap curves;
  for (const ex& symbol : symbols_of(definitions_, term)) {
    const auto found = coefficients_.find(symbol);
    if (found == coefficients_.end()) continue;
    ex curve = 0;
    for (unsigned j = order_ + 1; j-- > 0;) curve = curve * s_ + found->second[j];
    curves.emplace(symbol, curve.expand());
  }
  Coefficients result(order_ + 1, 0);
  result[0] = term;
  if (curves.empty()) return result;
  ex along = term.subs(curves, GiNaC::subs_options::no_pattern);
  GiNaC::numeric factorial = 1;
  for (unsigned j = 0; j <= order_; ++j) {
    if (j > 0) factorial *= j;
    result[j] = along.subs(s_ == 0, GiNaC::subs_options::no_pattern) / factorial;
    along = along.diff(s_);
  }
  return result;
}

TaylorSeries::Coefficients TaylorSeries::expand_value(const ex& value) const {
  if (!GiNaC::is_a<GiNaC::add>(value)) return coefficients_of(value);
  std::vector<GiNaC::exvector> terms(order_ + 1);
  for (std::size_t i = 0; i < value.nops(); ++i) {
    const Coefficients of_term = coefficients_of(value.op(i));
    for (unsigned j = 0; j <= order_; ++j) terms[j].push_back(of_term[j]);
  }
  Coefficients result;
  for (const GiNaC::exvector& of_order : terms) result.emplace_back(GiNaC::add(of_order));
  return result;
}

void TaylorSeries::expand_definition(std::uint32_t definition) {
  const Definition old = definitions_.list[definition];
  Coefficients coefficients = expand_value(old.value);
  // A definition that does not depend on small leaves keeps its symbol.
  if (coefficients[0].is_equal(old.value)) return;
  for (unsigned j = 0; j <= order_; ++j) {
    const std::string name = old.name.empty() ? "" : old.name + "_" + std::to_string(j);
    coefficients[j] = define(definitions_, coefficients[j], {name, old.origin});
  }
  coefficients_.emplace(old.symbol, std::move(coefficients));
}

ex TaylorSeries::operator()(const ex& value) {
  visit_needed_definitions(definitions_, value, mask_, known_,
                           [this](std::uint32_t definition) { expand_definition(definition); });
  return GiNaC::add(expand_value(value));
}

Lagrangian expand_energies(Lagrangian lagrangian) {
  const Expansion expansion = *lagrangian.expansion;
  write_energy_sums(lagrangian);
  TaylorSeries to_next_order(lagrangian.definitions, expansion.small, expansion.order + 1);
  for (auto* terms : {&lagrangian.kinetic, &lagrangian.potential, &lagrangian.dissipation,
                      &lagrangian.lagrangian}) {
    for (EnergyTerm& term : *terms) term.value = to_next_order(term.value);
  }
  TaylorSeries to_order(lagrangian.definitions, expansion.small, expansion.order);
  for (std::size_t i = 0; i < lagrangian.forces.size(); ++i) {
    ex& force = lagrangian.forces[i];
    force = is_small(expansion, lagrangian.symbols.v[i]) ? to_order(force) : to_next_order(force);
  }
  return lagrangian;
}

}  // namespace elgen
