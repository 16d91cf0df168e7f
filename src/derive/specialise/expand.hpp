// Taylor coefficients of expressions over definitions.
//
// With f(x0 + s (x - x0)) = f0 + s f1 + s^2 f2 + …, each definition is replaced by definitions of
// its coefficients, so that expressions stay small. Coefficients that are 0 get no definition.
//
//     before    h = l*cos(q), V = m*g*h               q near 0, order 2
//     after     h0 = l, h2 = -1/2*l*q^2               (h1 = 0)
//               V0 = m*g*h0, V2 = m*g*h2
#pragma once

#include <vector>

#include "elgen/lagrangian.hpp"

namespace elgen {

class TaylorSeries {
 public:
  TaylorSeries(Definitions& definitions, const std::vector<SmallLeaf>& small, unsigned order);

  /// f0 + f1 + … + f_order with f = `value`. Throws GiNaC's pole_error if f has no derivatives at
  /// x0.
  [[nodiscard]] GiNaC::ex operator()(const GiNaC::ex& value);

 private:
  using Coefficients = std::vector<GiNaC::ex>;

  [[nodiscard]] Coefficients expand_value(const GiNaC::ex& value) const;
  [[nodiscard]] Coefficients coefficients_of(const GiNaC::ex& term) const;
  void expand_definition(std::uint32_t definition);

  Definitions& definitions_;
  unsigned order_;
  LeafSet mask_ = {};
  GiNaC::symbol s_;
  ExpressionMap<Coefficients> coefficients_;  // of symbols that depend on small leaves
  std::vector<bool> known_;
};

}  // namespace elgen
