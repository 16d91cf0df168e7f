// The chain rule through an ordered list of definitions: forward, reverse, and substitution.
//
// GiNaC differentiates only the small value of one definition; these functions combine the partial
// derivatives. So a derivative costs at most a small multiple of its function. New definitions are
// appended to the same list. Results do not depend on GiNaC's order of terms.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "elgen/lagrangian.hpp"

namespace elgen {

/// Calls visit(index) for each definition that `value` needs directly or indirectly, operands
/// first. Skips definitions that are `known` or do not depend on a leaf in `mask`; marks visited
/// definitions as known. Iterative, because chains of definitions may be long.
template <class Visit>
void visit_needed_definitions(const Definitions& definitions, const GiNaC::ex& value, LeafSet mask,
                              std::vector<bool>& known, const Visit& visit) {
  std::vector<std::pair<std::uint32_t, bool>> stack;
  const auto push = [&](std::uint32_t index) {
    const bool is_known = index < known.size() && known[index];
    if (!is_known && definitions.list[index].leaf_dependence.has_any(mask))
      stack.emplace_back(index, false);
  };
  for (const GiNaC::ex& symbol : symbols_of(definitions, value)) {
    const SymbolPlace& at = definitions.places.at(symbol);
    if (at.is_definition) push(at.index);
  }
  while (!stack.empty()) {
    const auto [index, operands_done] = stack.back();
    if (index < known.size() && known[index]) {
      stack.pop_back();
    } else if (!operands_done) {
      stack.back().second = true;
      for (const std::uint32_t used : definitions.list[index].used_definitions) push(used);
    } else {
      stack.pop_back();
      if (known.size() <= index) known.resize(index + 1, false);
      known[index] = true;
      visit(index);
    }
  }
}

/// A factor of the chain rule: the partial derivative `value` of an expression with respect to
/// `variable`.
struct PartialDerivative {
  GiNaC::ex variable;
  GiNaC::ex value;
};

/// The non-zero partial derivatives of `value` with respect to its symbols that depend on a leaf in
/// `mask`, in elgen's order of symbols. A sum of n terms costs n small derivatives.
[[nodiscard]] std::vector<PartialDerivative> partial_derivatives(const Definitions& definitions,
                                                                 const GiNaC::ex& value,
                                                                 LeafSet mask);

/// Leaf x -> value. For a Tangent, the value is dx/ds; leaves without a value have dx/ds = 0. For a
/// Substitution, the value replaces x; leaves without a value are kept.
using Seeds = ExpressionMap<GiNaC::ex>;

/// seeds[leaves[i]] = values[i], unless the leaf has a seed already.
void add_seeds(Seeds& seeds, const std::vector<GiNaC::ex>& leaves,
               const std::vector<GiNaC::ex>& values);

/// The 4 x 3 matrix N of de/dt = N omega. The quaternion e = (w, x, y, z) rotates body axes to
/// parent axes; omega is the angular velocity in body axes:
///
///     N = 1/2 [ -x -y -z;  w -z  y;  z  w -x;  -y  x  w ]
[[nodiscard]] std::array<std::array<GiNaC::ex, 3>, 4> rate_matrix(const Symbols& symbols,
                                                                  const RotationPlace& rotation);

/// The seeds of d/dt along the motion: q -> dq/dt, v -> a, t -> 1.
[[nodiscard]] Seeds motion_seeds(const Symbols& symbols);

/// Forward: the derivative d/ds f = sum df/dx dx/ds along a direction; the seeds dx/ds state the
/// direction.
///
///     before    p = l*sin(q)              seeds q -> v
///     after     p_dot = l*cos(q)*v
///
/// A definition is differentiated once, at its first use. If the definition has a name, its
/// derivative has that name with `suffix` appended, such as "_dot". If `suffix` is empty,
/// derivatives have no names.
class Tangent {
 public:
  Tangent(Definitions& definitions, Seeds seeds, std::string suffix = {});

  /// d value/ds along the direction; `value` is any expression over the definitions.
  [[nodiscard]] GiNaC::ex operator()(const GiNaC::ex& value);

 private:
  /// d value/ds along the direction, from the derivatives in `tangents_`; `value` is an expression
  /// or a definition.
  template <class Value>
  [[nodiscard]] GiNaC::ex differentiate_value(const Value& value) const;
  void differentiate_definition(std::uint32_t definition);

  Definitions& definitions_;
  Seeds tangents_;  // d/ds of leaves, and of the definitions differentiated so far
  std::vector<bool> visited_;
  std::string suffix_;
  LeafSet mask_ = {};
};

/// The summand weight * value.
struct WeightedTerm {
  GiNaC::ex value;
  GiNaC::ex weight;
};

/// Reverse: the gradient of sum weight_k value_k with respect to `variables`, at constant weights.
///
///     before    E = m*p^2, p = l*q        variable q
///     after     adjoint of p = 2*m*p, dE/dq = adjoint*l
///
/// Each definition is differentiated once, whatever the number of variables.
[[nodiscard]] std::vector<GiNaC::ex> gradient(Definitions& definitions,
                                              const std::vector<WeightedTerm>& sum,
                                              const std::vector<GiNaC::ex>& variables);

/// Replaces leaves by values in all definitions that an expression needs.
///
///     before    f = k*(u - w), w = N*v    u -> 0
///     after     f' = k*(-w)
class Substitution {
 public:
  Substitution(Definitions& definitions, Seeds values);

  [[nodiscard]] GiNaC::ex operator()(const GiNaC::ex& value);

 private:
  [[nodiscard]] GiNaC::ex substitute_value(const GiNaC::ex& value) const;
  void substitute_definition(std::uint32_t definition);

  Definitions& definitions_;
  Seeds values_;
  std::vector<bool> visited_;
  LeafSet mask_ = {};
};

}  // namespace elgen
