// The chain rule through an ordered list of definitions: forward, reverse, and substitution.
//
// GiNaC differentiates the small value of one definition only; everything else is bookkeeping here,
// so that a derivative costs a small constant times what it is a derivative of. New definitions are
// appended to the same list. Results do not depend on GiNaC's order of terms.
#pragma once

#include <string>
#include <vector>

#include "elgen/lagrangian.hpp"

namespace elgen {

/// One factor of the chain rule: d value/d variable.
struct Partial {
  GiNaC::ex variable;
  GiNaC::ex value;
};

/// The partial derivatives of `value` by its symbols that depend on anything in `mask`, in elgen's
/// order. A sum of n terms costs n small derivatives.
[[nodiscard]] std::vector<Partial> partials(const Definitions& definitions, const GiNaC::ex& value,
                                            LeafSet mask);

/// Rates of the leaves along a direction; a leaf that is absent stands still.
using Seeds = ExpressionMap<GiNaC::ex>;

/// q -> dq/dt, v -> a, t -> 1: the motion. Parts are left out by leaving their seeds out.
[[nodiscard]] Seeds motion_seeds(const Symbols& symbols);

/// Forward: the derivative along a direction, d/ds f = sum df/dx dx/ds.
///
///     before    p = l*sin(q)              direction q -> v
///     after     p_dot = l*cos(q)*v
///
/// Each definition gets one derivative definition, on first demand. `suffix` names them ("_dot").
class Tangent {
 public:
  Tangent(Definitions& definitions, Seeds seeds, std::string suffix = {});

  /// The derivative of any expression over the definitions.
  [[nodiscard]] GiNaC::ex operator()(const GiNaC::ex& value);

 private:
  [[nodiscard]] GiNaC::ex from_known(const GiNaC::ex& value) const;
  void differentiate(std::uint32_t definition);

  Definitions& definitions_;
  Seeds tangents_;  // of leaves, then of definitions as they are asked for
  std::vector<bool> known_;
  std::string suffix_;
  LeafSet mask_ = {};
};

/// An expression with the factor it enters a sum with.
struct Weighted {
  GiNaC::ex value;
  GiNaC::ex weight;
};

/// Reverse: the gradient of sum weight_k value_k (weights held constant) by each of `variables`.
///
///     before    E = m*p^2, p = l*q        by q
///     after     adjoint of p = 2*m*p, dE/dq = adjoint*l
///
/// Each definition is visited once, however many variables there are.
[[nodiscard]] std::vector<GiNaC::ex> gradient(Definitions& definitions,
                                              const std::vector<Weighted>& sum,
                                              const std::vector<GiNaC::ex>& variables);

/// Replaces leaves by values throughout the definitions an expression needs.
///
///     before    f = k*(u - w), w = N*v    u -> 0
///     after     f' = k*(-w)
class Substitution {
 public:
  Substitution(Definitions& definitions, Seeds values);

  [[nodiscard]] GiNaC::ex operator()(const GiNaC::ex& value);

 private:
  [[nodiscard]] GiNaC::ex from_known(const GiNaC::ex& value) const;
  void substitute(std::uint32_t definition);

  Definitions& definitions_;
  Seeds values_;
  std::vector<bool> known_;
  LeafSet mask_ = {};
};

}  // namespace elgen
